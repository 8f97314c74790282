# The C API as well, by its shared libraries: what a host in another mode calls.
target_link_libraries(test_host_modes PRIVATE plumb_c plumb_certify)
