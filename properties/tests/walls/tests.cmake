# Walls with seeded bugs: fuzz/bugs/walls.
plumb_add_sown_library(test_walls walls scene/wall plumb_solver Boost::headers)
