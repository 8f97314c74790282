# The scripts of .ci/, with a Python that need not be Debian's.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  add_test(NAME ci/scripts COMMAND ${CMAKE_COMMAND} -E echo "not run: needs python3")
  set_tests_properties(ci/scripts PROPERTIES SKIP_REGULAR_EXPRESSION "not run")
  return()
endif()
add_test(NAME ci/scripts COMMAND ${Python3_EXECUTABLE} -B -m unittest --verbose test_scripts WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
