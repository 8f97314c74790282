// A hull of plumb.h that is destroyed at the end of its block.
#pragma once

#include <memory>

#include "solver/plumb.h"

namespace plumb {

struct DestroyHull {
  void operator()(plumb_hull* hull) const { plumb_hull_destroy(hull); }
};
using OwnedHull = std::unique_ptr<plumb_hull, DestroyHull>;

}  // namespace plumb
