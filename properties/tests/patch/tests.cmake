# The patch with seeded bugs, each of which the laws must find: fuzz/bugs/patch.
plumb_add_sown_library(test_patch patch patch Eigen3::Eigen)
