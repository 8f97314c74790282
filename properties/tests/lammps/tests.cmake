# The driver is there where LAMMPS is; without it the tests that run it say so and are skipped.
target_link_libraries(test_lammps PRIVATE plumb_lammps_runs plumb_lammps_files plumb_scene_files fmt::fmt)
add_dependencies(test_lammps plumb plumb-export-lammps)
if(TARGET plumb-lammps)
  target_compile_definitions(test_lammps PRIVATE PLUMB_LAMMPS_PROGRAM="$<TARGET_FILE:plumb-lammps>")
  add_dependencies(test_lammps plumb-lammps)
endif()
