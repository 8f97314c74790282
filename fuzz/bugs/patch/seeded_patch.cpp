// The patch with a bug in it, in a library of its own: the C door that the other seeded bugs are behind has no patch.
#include "solver/contact.cpp"
#include "solver/patch/patch.cpp"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(double)

}  // namespace plumb

#include "fuzz/bugs/seeded_rows.hpp"

/// Of a contact in the pair's frame.
PLUMB_EXPORT void seeded_patch(int bug, const plumb::Pair* pair, const plumb::Contact<double>* contact,
                               double tolerance, plumb::Patch* patch) {
  select_bug(bug);
  const plumb::PairFrame<double> frame(*pair);
  *patch = plumb::patch_at(*pair, contact->normal, frame.to_pair_point(contact->point1, *pair),
                           frame.to_pair_point(contact->point2, *pair), tolerance);
}
