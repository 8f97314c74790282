target_link_libraries(test_stability PRIVATE plumb_stability)
add_dependencies(test_stability plumb plumb-ladder plumb-replay plumb-report-stability)
