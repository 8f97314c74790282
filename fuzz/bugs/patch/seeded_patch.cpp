// The patch with a bug in it, in a library of its own: the C door that the other seeded bugs are behind has no patch.
#include <iterator>

#include "solver/contact.cpp"
#include "solver/patch/patch.cpp"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(double)

}  // namespace plumb

namespace {

struct Row {
  std::string_view name;
  int number;
};

#define PLUMB_SEEDED_BUGS_MARK
#include "bugs.inc"

}  // namespace

#define PLUMB_EXPORT extern "C" [[gnu::visibility("default")]]

/// Bug 0 .. seeded_patch_bugs() - 1, and -1 for none, of a contact in the pair's frame.
PLUMB_EXPORT void seeded_patch(int bug, const plumb::Pair* pair, const plumb::Contact<double>* contact,
                               double tolerance, plumb::Patch* patch) {
  plumb::bug_of_thread = bug < 0 ? 0 : kRows[bug].number;
  const plumb::PairFrame<double> frame(*pair);
  *patch = plumb::patch_at(*pair, contact->normal, frame.to_pair_point(contact->point1, *pair),
                           frame.to_pair_point(contact->point2, *pair), tolerance);
}
PLUMB_EXPORT int seeded_patch_bugs() {
  return static_cast<int>(std::size(kRows));
}
PLUMB_EXPORT const char* seeded_patch_name(int bug) {
  return kRows[bug].name.data();
}
