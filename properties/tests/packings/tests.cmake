# reports/packings: its shapes, its table, and one short run with the plumb-scene of this build.
add_test(NAME packings/suite COMMAND /usr/bin/python3 -B -m unittest --verbose test_packings WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
set_tests_properties(packings/suite PROPERTIES TIMEOUT 300 ENVIRONMENT
                     "PYTHONPATH=${PROJECT_SOURCE_DIR}/reports/packings;PLUMB_SCENE=$<TARGET_FILE:plumb-scene>")
