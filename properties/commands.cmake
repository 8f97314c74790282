# The commands that judge: they need the laws, so they live here and not in corpus/.
add_executable(plumb-check check.cpp)
add_executable(plumb-ladder ladder.cpp)
add_executable(plumb-path path.cpp)
add_executable(plumb-promote promote.cpp life.cpp replay_case.cpp replay_reports.cpp)
add_executable(plumb-replay replay.cpp life.cpp replay_case.cpp replay_reports.cpp)
foreach(program plumb-check plumb-ladder plumb-path plumb-promote plumb-replay)
  target_link_libraries(${program} PRIVATE plumb_properties plumb_command plumb_flags fmt::fmt)
endforeach()
