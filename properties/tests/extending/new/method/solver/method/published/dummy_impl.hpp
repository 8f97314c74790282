// A method for tests: new_cn under another name.
#pragma once

#include "solver/method/method_table.hpp"

namespace plumb {

template <class S>
Contact<S> dummy(const Pair& pair, const Want& want, const Contact<S>* last) {
  Contact<S> out = new_cn<S>(pair, want, last);
  out.method = "dummy";
  return out;
}

}  // namespace plumb
