# The C API as others link it: by its shared libraries.
target_link_libraries(test_c_api PRIVATE plumb_c plumb_certify)
target_sources(test_c_api PRIVATE ${folder}/header.c)
set_source_files_properties(${folder}/header.c PROPERTIES COMPILE_OPTIONS "-std=c99" SKIP_UNITY_BUILD_INCLUSION ON)
target_compile_definitions(test_c_api PRIVATE PLUMB_C_LIBRARY="$<TARGET_FILE:plumb_c>" PLUMB_CERTIFY_LIBRARY="$<TARGET_FILE:plumb_certify>")
# The builds that the figures of plumb.h for the stack are of.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$"
   AND NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-fsanitize")
  target_compile_definitions(test_c_api PRIVATE PLUMB_HAS_STACK_FIGURES)
endif()

# With the library's sources in the program, so that clang's sanitizers, which are the program's, see them.
add_executable(extreme_calls ${folder}/extreme_calls/extreme_calls.cpp ${PROJECT_SOURCE_DIR}/solver/c/plumb.cpp
                             ${PROJECT_SOURCE_DIR}/solver/c/convex.cpp ${PROJECT_SOURCE_DIR}/solver/c/details.cpp)
target_compile_definitions(extreme_calls PRIVATE PLUMB_LIBRARY_VERSION="${PROJECT_VERSION}")
target_link_libraries(extreme_calls PRIVATE plumb_batch plumb_flags)
add_test(NAME c_api/extreme_calls COMMAND extreme_calls)
