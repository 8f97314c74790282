# reports/verify: its closed forms, its table, and a few rows with the plumb-scene of this build. Where mpmath is not there, nothing.
execute_process(COMMAND /usr/bin/python3 -c "import mpmath, numpy" RESULT_VARIABLE no_mpmath OUTPUT_QUIET ERROR_QUIET)
if(no_mpmath)
  add_test(NAME verify/suite COMMAND ${CMAKE_COMMAND} -E echo "not run: needs python3-mpmath")
  set_tests_properties(verify/suite PROPERTIES SKIP_REGULAR_EXPRESSION "not run")
  return()
endif()
add_test(NAME verify/suite COMMAND /usr/bin/python3 -B -m unittest --verbose test_verify WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
set_tests_properties(verify/suite PROPERTIES TIMEOUT 300 ENVIRONMENT
                     "PYTHONPATH=${PROJECT_SOURCE_DIR}/reports/verify;PLUMB_SCENE=$<TARGET_FILE:plumb-scene>")
