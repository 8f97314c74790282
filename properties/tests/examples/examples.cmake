# What users copy: each example runs in a folder of its own beside nothing but the installed tree, as a user's would.
set(plumb_installed ${PROJECT_BINARY_DIR}/installed)
add_test(NAME install/tree COMMAND env BUILD=${PROJECT_BINARY_DIR} PREFIX=${plumb_installed} ${CMAKE_CURRENT_LIST_DIR}/install/run)
set_tests_properties(install/tree PROPERTIES FIXTURES_SETUP installed TIMEOUT 120)

add_test(NAME install/library_only
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/library_only ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/examples/library_only)
set_tests_properties(install/library_only PROPERTIES TIMEOUT 300)

# add_example(NAME FOLDER [VARIABLE=VALUE..]): FOLDER/run in a copy of FOLDER; it must print FOLDER/expected.
function(add_example name folder)
  add_test(NAME install/${name} COMMAND env ${ARGN} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/check
                                        ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${folder} ${PROJECT_BINARY_DIR}/examples/${name} ${plumb_installed})
  set_tests_properties(install/${name} PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 300)
endfunction()

add_example(tutorial tutorial PLUMB=${PROJECT_SOURCE_DIR})
add_example(cpp.g++ cpp CXX=g++)
add_example(components components)
add_test(NAME install/missing_component COMMAND ${CMAKE_CURRENT_LIST_DIR}/missing_component ${plumb_installed}
                                                ${PROJECT_BINARY_DIR}/examples/missing_component)
set_tests_properties(install/missing_component PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 120)
add_example(c.gcc c CC=gcc)
find_program(PLUMB_CLANG NAMES clang++-19 clang++)
if(PLUMB_CLANG)
  string(REPLACE clang++ clang clang ${PLUMB_CLANG})
  add_example(cpp.clang cpp CXX=${PLUMB_CLANG})
  add_example(c.clang c CC=${clang})
endif()
add_example(patch patch)
add_example(shapes shapes)
add_example(recorder recorder)
add_example(import import)
add_example(cluster cluster)
if(TARGET python)
  get_target_property(interpreter python PLUMB_INTERPRETER)
  add_example(python python PYTHON=${interpreter})
endif()

add_test(NAME install/packages COMMAND ${CMAKE_CURRENT_LIST_DIR}/packages ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}/examples/packages)
set_tests_properties(install/packages PROPERTIES FIXTURES_REQUIRED installed TIMEOUT 300)

# As root, and on a machine of one processor, Open MPI asks for these.
if(TARGET plumb-lammps)
  add_example(lammps lammps OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
              OMPI_MCA_mpi_yield_when_idle=1)
endif()
