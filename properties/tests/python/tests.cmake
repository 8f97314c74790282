# The Python package's tests, one entry a file; they run the package of this build and the programs beside it.
if(NOT TARGET python)
  add_test(NAME python/package COMMAND ${CMAKE_COMMAND} -E echo "not built: needs python3-dev, python3-numpy and pybind11-dev")
  set_tests_properties(python/package PROPERTIES SKIP_REGULAR_EXPRESSION "not built")
  return()
endif()
get_target_property(interpreter python PLUMB_INTERPRETER)
file(GLOB plumb_python_tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/test_*.py)
foreach(file IN LISTS plumb_python_tests)
  string(REGEX REPLACE "^test_(.+)[.]py$" "\\1" name ${file})
  add_test(NAME python/${name} COMMAND ${interpreter} -B -m unittest --verbose test_${name}
           WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
  set_tests_properties(python/${name} PROPERTIES TIMEOUT 300 ENVIRONMENT
                       "PYTHONPATH=${PROJECT_BINARY_DIR}/python;PLUMB_SOURCE_DIR=${PROJECT_SOURCE_DIR};PLUMB_BINARY_DIR=${PROJECT_BINARY_DIR};MPLBACKEND=Agg")
endforeach()
