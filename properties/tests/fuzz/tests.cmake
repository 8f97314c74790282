# The campaign as a library, and the programs that the tests of the command line start.
target_link_libraries(test_fuzz PRIVATE plumb_targets plumb_hunt fmt::fmt)
add_dependencies(test_fuzz plumb plumb-solve plumb-campaign plumb-merge plumb-families plumb-fuzz-run plumb-ladder plumb-methods plumb-shrink plumb-fuzz plumb-replay
                 replay-pair replay-contact replay-case replay-patch replay-shapes replay-path replay-scene replay-files replay-mesh plumb-path
                 foreign_sphere peers)

# A foreign solver that does what it is told to by the environment, and the worked example.
add_library(foreign_misbehaving MODULE ${folder}/foreign/misbehaving.cpp)
add_library(foreign_example MODULE ${PROJECT_SOURCE_DIR}/fuzz/example/bounding_spheres.c)
target_link_libraries(foreign_example PRIVATE m)
add_library(foreign_limited MODULE ${folder}/foreign/limited.cpp)
target_link_libraries(foreign_limited PRIVATE plumb_solver plumb_flags)
# `auto` with a fault that the environment names.
add_library(foreign_planted MODULE ${folder}/foreign/planted.cpp)
target_link_libraries(foreign_planted PRIVATE plumb_solver plumb_flags)
foreach(library foreign_misbehaving foreign_example foreign_limited foreign_planted)
  target_include_directories(${library} PRIVATE ${PROJECT_SOURCE_DIR})
  set_target_properties(${library} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_dependencies(test_fuzz ${library})
endforeach()
