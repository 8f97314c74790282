# The campaign as a library, and the programs that the tests of the command line start.
target_link_libraries(test_fuzz PRIVATE plumb_fuzz fmt::fmt)
add_dependencies(test_fuzz plumb plumb-campaign plumb-merge plumb-families plumb-fuzz-run plumb-methods plumb-shrink plumb-replay
                 replay-pair replay-case foreign_sphere peers)
