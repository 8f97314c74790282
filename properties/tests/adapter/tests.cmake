# The worked example in C++, as its page compiles it: C++17, plumb_adapter.hpp and nothing of plumb's else. That in C is test_fuzz's.
add_library(foreign_example_cpp MODULE ${PROJECT_SOURCE_DIR}/fuzz/example/bounding_spheres.cpp)
target_link_libraries(foreign_example_cpp PRIVATE plumb_flags)
set_target_properties(foreign_example_cpp PROPERTIES CXX_STANDARD 17 PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
add_dependencies(test_adapter foreign_example foreign_example_cpp plumb-solver-host)
