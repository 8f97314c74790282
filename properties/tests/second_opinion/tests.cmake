# The program that these tests ask, and solvers to ask it about.
target_link_libraries(test_second_opinion PRIVATE fmt::fmt)
add_dependencies(test_second_opinion second-opinion)
if(TARGET peers)
  add_dependencies(test_second_opinion peers)
endif()
