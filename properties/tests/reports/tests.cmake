# Only what the program prints is looked at.
target_link_libraries(test_reports PRIVATE fmt::fmt)
add_dependencies(test_reports bench plumb plumb-solve plumb-report-gate)
