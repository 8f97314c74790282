// The door to the bounds, apart from the methods': no method can reach what checks it.
#include "solver/js/wasm/block.hpp"
#include "solver/reference/overlap_bounds.hpp"

/// Bounds the lowest overlap of the block's pair, from the normal and the points in the block's outputs.
extern "C" void plumb_js_bound(int cells) {
  using namespace plumb::js;
  plumb::Contact<double> contact;
  contact.normal = three(normal);
  contact.point1 = three(point1);
  contact.point2 = three(point2);
  const plumb::reference::OverlapBounds found = plumb::reference::bound_overlap(given(), contact, cells);
  block[bounds] = found.lower;
  block[bounds + 1] = found.upper;
}
