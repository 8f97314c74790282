// plumb._native: what the package takes from the library. The public names, with their signatures, are in plumb/.
#include "solver/python/bindings.hpp"

PYBIND11_MODULE(_native, module) {
  pybind11::options options;
  options.disable_function_signatures();
  module.attr("__version__") = PLUMB_VERSION;
  plumb::python::add_shapes(module);
  plumb::python::add_body(module);
  plumb::python::add_contact(module);
  plumb::python::add_solve(module);
  plumb::python::add_batch(module);
}
