# reports/case_study: its scene, its model of costs, and one short run where the LAMMPS of this build is there.
add_test(NAME case_study/suite COMMAND /usr/bin/python3 -B -m unittest --verbose test_case_study WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
set_tests_properties(case_study/suite PROPERTIES TIMEOUT 300 ENVIRONMENT
                     "PYTHONPATH=${PROJECT_SOURCE_DIR}/reports/case_study:${PROJECT_SOURCE_DIR}/reports/verify;PLUMB_PROGRAMS=$<TARGET_FILE_DIR:plumb-scene>")
