// Every method in one scalar: what the sources that instantiate them for one other than double hold. The table takes the address of each,
// with which it is instantiated.
#pragma once

// Declares what the others define: clang takes [[nodiscard]] at the first declaration alone.
#include "solver/method/method_table.hpp"

#include "method_bodies.inc"
#include "solver/method/auto/automatic_impl.hpp"

#define PLUMB_INSTANTIATE_METHODS(S) \
  PLUMB_INSTANTIATE_AUTOMATIC(S)     \
  template const MethodIn<S>* find_method_in<S>(std::string_view name);
