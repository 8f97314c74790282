# plumb_add_sown_library(TEST NAME FOLDER LIBRARIES..): fuzz/bugs/NAME/seeded_NAME.cpp as a library, with the bugs of NAME.json sown in solver/FOLDER
# (seed.cmake), for a test that must find each: it has the library's path as PLUMB_SEEDED_NAME.
set(PLUMB_BUGS ${CMAKE_CURRENT_LIST_DIR})
function(plumb_add_sown_library test name folder)
  string(TOUPPER PLUMB_SEEDED_${name} path)
  target_link_libraries(${test} PRIVATE ${CMAKE_DL_LIBS})
  if(PLUMB_ONE_COMPILATION)  # the linter sows nothing
    target_compile_definitions(${test} PRIVATE ${path}="")
    return()
  endif()
  set(library seeded_${name})
  set(source ${PLUMB_BUGS}/${name}/${library}.cpp)
  set(table ${PLUMB_BUGS}/${name}/${name}.json)
  set(sown ${CMAKE_CURRENT_BINARY_DIR}/${library})
  file(GLOB_RECURSE pristine CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/*.hpp ${PROJECT_SOURCE_DIR}/solver/${folder}/*)
  add_custom_command(OUTPUT ${sown}/stamp
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TABLES=${table} -D OUT=${sown} -P ${PLUMB_BUGS}/seed.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${sown}/stamp
    DEPENDS ${PLUMB_BUGS}/seed.cmake ${table} ${pristine} COMMENT "Seeding bugs of ${name}" VERBATIM)
  add_library(${library} MODULE ${source})
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${sown}/stamp)
  target_include_directories(${library} BEFORE PRIVATE ${sown})
  target_link_libraries(${library} PRIVATE ${ARGN} plumb_flags)
  target_compile_options(${library} PRIVATE -include ${PLUMB_BUGS}/seeded_bug.hpp -ftls-model=initial-exec)
  target_link_options(${library} PRIVATE -Wl,-Bsymbolic)
  set_target_properties(${library} PROPERTIES PREFIX "" UNITY_BUILD OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  add_dependencies(${test} ${library})
  target_compile_definitions(${test} PRIVATE ${path}="$<TARGET_FILE:${library}>")
endfunction()
