# What of reports/fem needs no engine: shapes, gaps, half-spaces, decks, tables; what is judged, checked and kept; patches. With gmsh and CalculiX, one contact from end to end as well.
if(NOT TARGET python)
  add_test(NAME fem/parts COMMAND ${CMAKE_COMMAND} -E echo "not run: needs python3-numpy")
  set_tests_properties(fem/parts PROPERTIES SKIP_REGULAR_EXPRESSION "not run")
  return()
endif()
get_target_property(interpreter python PLUMB_INTERPRETER)
foreach(name parts study patches contact)
  add_test(NAME fem/${name} COMMAND ${interpreter} -B -m unittest --verbose test_${name} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
  set_tests_properties(fem/${name} PROPERTIES TIMEOUT 300 ENVIRONMENT
                       "PYTHONPATH=${PROJECT_SOURCE_DIR}/reports/fem;OPENBLAS_NUM_THREADS=1;OMP_NUM_THREADS=1")
endforeach()
set_tests_properties(fem/contact PROPERTIES SKIP_REGULAR_EXPRESSION "skipped 'needs")
