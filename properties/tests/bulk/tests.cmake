# reports/bulk: shapes, scenes, measures and tables of its studies, with short runs by the plumb-scene of this build.
foreach(study runs packings hopper)
  add_test(NAME bulk/${study} COMMAND /usr/bin/python3 -B -m unittest --verbose test_${study} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
  set_tests_properties(bulk/${study} PROPERTIES TIMEOUT 300 ENVIRONMENT
                       "PYTHONPATH=${PROJECT_SOURCE_DIR}/reports/bulk:${PROJECT_SOURCE_DIR}/reports/verify;PLUMB_SCENE=$<TARGET_FILE:plumb-scene>")
endforeach()
