target_link_libraries(test_scene_files PRIVATE fmt::fmt plumb_scene_files)
add_dependencies(test_scene_files plumb plumb-solve plumb-replay plumb-scene plumb-scenes)
