// What each file adds to the module plumb._native.
#pragma once

#include <pybind11/pybind11.h>

namespace plumb::python {

void add_shapes(pybind11::module_& module);
void add_body(pybind11::module_& module);
void add_contact(pybind11::module_& module);
void add_solve(pybind11::module_& module);
void add_batch(pybind11::module_& module);

}  // namespace plumb::python
