# Foreign programs (--solver-command), in Python and in JavaScript where there is a Node; and the helpers that such programs use.
add_dependencies(test_solvers plumb-command-host)
find_package(Python3 QUIET COMPONENTS Interpreter)
find_program(PLUMB_NODE node)
if(NOT PLUMB_NODE)
  set(PLUMB_NODE "")
endif()
target_compile_definitions(test_solvers PRIVATE PLUMB_PYTHON="${Python3_EXECUTABLE}" PLUMB_NODE="${PLUMB_NODE}")
