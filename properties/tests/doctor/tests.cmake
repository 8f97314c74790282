# A foreign solver that makes the mistakes that the environment names; the worked example and one that misbehaves are test_fuzz's.
target_link_libraries(test_doctor PRIVATE plumb_doctor)
add_library(foreign_mistaken MODULE ${folder}/foreign/mistaken.cpp)
target_link_libraries(foreign_mistaken PRIVATE plumb_solver plumb_flags)
target_include_directories(foreign_mistaken PRIVATE ${PROJECT_SOURCE_DIR})
set_target_properties(foreign_mistaken PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
add_dependencies(test_doctor foreign_mistaken foreign_example plumb plumb-doctor)
