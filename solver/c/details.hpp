// plumb_details: what there is of a contact beside its numbers.
#pragma once

#include "solver/contact.hpp"
#include "solver/plumb.h"

namespace plumb {

/// Null, or with a size that its own field fits in.
[[nodiscard]] inline bool are_legal(const plumb_details* details) {
  return details == nullptr || details->size >= sizeof details->size;
}

/// As much as the caller's struct, which says its size, has room for.
void write_details(const Contact<double>& found, plumb_details& details);

}  // namespace plumb
