// The one list of laws, in the order in which the first that is broken is told. A finding's line is that of its law's row here.
#include <array>

#include "properties/laws/laws.hpp"
#include "properties/laws/laws_answer.hpp"
#include "properties/laws/laws_problem.hpp"
#include "properties/laws/laws_symmetry.hpp"

namespace plumb {
namespace {

constexpr std::array all_laws{
    Law{"finite", "no number of a converged answer is NaN or infinite", law::answers_are_finite, Needs::nothing},
    Law{"converges", "the method vouches for its residual", law::converges, Needs::nothing},
    Law{"verdict", "overlapping when the certified overlap is positive, not when it is negative", law::verdict_is_right,
        Needs::nothing},
    Law{"lowest", "of all common normals it is the one of lowest overlap", law::has_the_lowest_overlap},
    Law{"opposite", "n1 + n2 = 0", law::normals_are_opposite, Needs::rounding},
    Law{"collinear", "p2 - p1 = -overlap n1", law::points_lie_on_the_normal, Needs::rounding},
    Law{"normal", "the unit normal is the certified one", law::normal_agrees},
    Law{"itself", "p1 - p2 = overlap times normal (first touch: along the normal)", law::agrees_with_itself},
    Law{"deepest", "no point of a surface lies deeper in the other's potential than its own point",
        law::points_are_deepest, Needs::rounding},
    Law{"balance", "midway: equal potentials and opposite gradients at the contact point",
        law::potentials_balance_midway, Needs::rounding},
    Law{"undone", "first touch: p1 - p2 lies along the motion that is undone", law::motion_is_undone, Needs::rounding},
    Law{"surface", "each point is on its body's surface", law::points_are_on_surfaces},
    Law{"overlap", "the overlap is the certified one", law::overlap_agrees, Needs::nothing},
    Law{"points", "the points are the certified ones", law::points_agree},
    Law{"between", "a common normal's contact point lies between its points", law::contact_point_is_between},
    Law{"swap", "(B, A) gives the answer of (A, B) seen from the other side", law::swap_changes_nothing,
        Needs::rounding},
    Law{"motion", "a rigid motion moves the answer along", law::rigid_motion_changes_nothing, Needs::rounding},
    Law{"limit", "spheres have their closed form; exponents one step above 2 give the ellipsoid's answer",
        law::limits_are_reached, Needs::rounding},
    Law{"unit", "a change of the unit of length changes nothing else", law::unit_changes_nothing, Needs::rounding},
    Law{"repeat", "the same pair gives the same bits", law::repeats_bit_for_bit, Needs::rounding},
    Law{"evaluations", "at most 2000 evaluations", law::evaluations_are_few},
};

}  // namespace

std::span<const Law> laws() {
  return all_laws;
}

}  // namespace plumb
