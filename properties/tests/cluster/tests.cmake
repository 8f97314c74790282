# Campaigns over several processes: the library's chunks, and the programs.
target_link_libraries(test_cluster PRIVATE plumb_fuzz)
add_dependencies(test_cluster plumb plumb-campaign plumb-merge)
if(TARGET plumb-campaign-mpi)
  add_dependencies(test_cluster plumb-campaign-mpi)
endif()
