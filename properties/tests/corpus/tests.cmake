# The programs that these tests start, and foreign solvers to load.
target_link_libraries(test_corpus PRIVATE fmt::fmt plumb_command plumb_scene_files)
target_sources(test_corpus PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/command/life.cpp ${CMAKE_CURRENT_SOURCE_DIR}/command/replay_case.cpp
                                   ${CMAKE_CURRENT_SOURCE_DIR}/command/replay_reports.cpp)
foreach(variant IN ITEMS sphere future mute)
  add_library(foreign_${variant} MODULE ${folder}/foreign/${variant}.c)
  target_include_directories(foreign_${variant} PRIVATE ${PROJECT_SOURCE_DIR})
  set_target_properties(foreign_${variant} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_dependencies(test_corpus foreign_${variant})
endforeach()
add_dependencies(test_corpus plumb plumb-solve plumb-methods plumb-certify plumb-check plumb-promote plumb-replay plumb-path)
