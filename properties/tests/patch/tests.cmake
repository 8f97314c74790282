# The patch with seeded bugs, each of which the laws must find: fuzz/bugs/patch/patch.json, sown by fuzz/bugs/seed.cmake.
target_link_libraries(test_patch PRIVATE ${CMAKE_DL_LIBS})
if(PLUMB_ONE_COMPILATION)  # the linter sows nothing
  target_compile_definitions(test_patch PRIVATE PLUMB_SEEDED_PATCH="")
  return()
endif()
set(bugs ${PROJECT_SOURCE_DIR}/fuzz/bugs)
set(sown ${CMAKE_CURRENT_BINARY_DIR}/seeded_patch)
file(GLOB_RECURSE pristine CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/patch/*)
add_custom_command(OUTPUT ${sown}/stamp
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TABLES=${bugs}/patch/patch.json -D OUT=${sown} -P ${bugs}/seed.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${sown}/stamp
  DEPENDS ${bugs}/seed.cmake ${bugs}/patch/patch.json ${pristine} COMMENT "Seeding bugs of the patch" VERBATIM)
add_library(seeded_patch MODULE ${bugs}/patch/seeded_patch.cpp)
set_source_files_properties(${bugs}/patch/seeded_patch.cpp PROPERTIES OBJECT_DEPENDS ${sown}/stamp)
target_include_directories(seeded_patch BEFORE PRIVATE ${sown})
target_link_libraries(seeded_patch PRIVATE Eigen3::Eigen plumb_flags)
target_compile_options(seeded_patch PRIVATE -include ${bugs}/seeded_bug.hpp -ftls-model=initial-exec)
target_link_options(seeded_patch PRIVATE -Wl,-Bsymbolic)
set_target_properties(seeded_patch PROPERTIES PREFIX "" UNITY_BUILD OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
add_dependencies(test_patch seeded_patch)
target_compile_definitions(test_patch PRIVATE PLUMB_SEEDED_PATCH="$<TARGET_FILE:seeded_patch>")
