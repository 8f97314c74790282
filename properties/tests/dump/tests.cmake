# The reader as a library, and the programs that these tests start.
target_link_libraries(test_dump PRIVATE fmt::fmt plumb_dump plumb_scene_files)
add_dependencies(test_dump plumb plumb-import plumb-export plumb-scene)
