# The commands that judge: they need the laws, so they live here and not in corpus/.
add_executable(plumb-check command/check_main.cpp)
add_executable(plumb-ladder command/ladder_main.cpp)
add_executable(plumb-path command/path_main.cpp)
add_executable(plumb-promote command/promote_main.cpp command/life.cpp command/replay_case.cpp command/replay_reports.cpp)
add_executable(plumb-replay command/replay_main.cpp command/life.cpp command/replay_case.cpp command/replay_reports.cpp)
foreach(program plumb-check plumb-ladder plumb-path plumb-promote plumb-replay)
  target_link_libraries(${program} PRIVATE plumb_properties plumb_command plumb_flags fmt::fmt)
endforeach()

# The self-check of a foreign solver's adapter: a library for its tests, and the command.
file(GLOB plumb_doctor_sources CONFIGURE_DEPENDS doctor/*.cpp)
list(FILTER plumb_doctor_sources EXCLUDE REGEX "_main\\.cpp$")
add_library(plumb_doctor ${plumb_doctor_sources})
target_link_libraries(plumb_doctor PUBLIC plumb_corpus plumb_reference plumb_solver PRIVATE plumb_flags fmt::fmt)
add_executable(plumb-doctor doctor/doctor_main.cpp)
target_link_libraries(plumb-doctor PRIVATE plumb_doctor plumb_command plumb_flags fmt::fmt)
