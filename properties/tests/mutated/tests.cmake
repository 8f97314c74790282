# Files edited badly, by a Python that need not be Debian's, through the programs that read them.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  add_test(NAME mutated/files COMMAND ${CMAKE_COMMAND} -E echo "not run: needs python3")
  set_tests_properties(mutated/files PROPERTIES SKIP_REGULAR_EXPRESSION "not run")
  return()
endif()
add_test(NAME mutated/files COMMAND ${Python3_EXECUTABLE} -B -m unittest --verbose test_mutated WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
set_tests_properties(mutated/files PROPERTIES TIMEOUT 1500 COST 100 ENVIRONMENT "PLUMB_BINARY_DIR=${PROJECT_BINARY_DIR}")
