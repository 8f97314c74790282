#include "solver/reference/proof/proof.hpp"

#include <algorithm>
#include <cmath>

#include "solver/reference/interval/digits.hpp"
#include "solver/reference/proof/meridian.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

using OfCover = Interval19;  // of the cover: thousands of cells, each with some room
using Fine = Interval80;     // of the solutions: a few, to all digits

constexpr int deepest_leaf = 48;  // the corners of smaller cells are not exact in double

std::string of_region(std::size_t index) {
  return "region " + std::to_string(index) + ": ";
}

/// How many leaves of each sort a tree has, and how deep they are.
struct TreeShape {
  bool complete = false;  ///< six faces, and nothing after them
  int depth = 0;
  std::size_t with_witness = 0, in_region = 0;
};

/// Without recursion: a tree may be as deep as its maker liked.
TreeShape shape_of(const std::vector<Leaf>& tree) {
  TreeShape out;
  std::vector<int> left{6};  // of the cells at each depth, how many are still to come
  for (const Leaf leaf : tree) {
    while (!left.empty() && left.back() == 0) left.pop_back();
    if (left.empty()) return out;
    --left.back();
    if (leaf == Leaf::split) left.push_back(4);
    out.depth = std::max(out.depth, static_cast<int>(left.size()) - 1);
    out.with_witness += leaf != Leaf::split && leaf != Leaf::convex;
    out.in_region += leaf == Leaf::bounded || leaf == Leaf::convex;
  }
  out.complete = std::all_of(left.begin(), left.end(), [](int n) { return n == 0; });
  return out;
}

std::string find_misshape(const Proof& proof) {
  const TreeShape shape = shape_of(proof.cover.tree);
  if (!shape.complete) return "the tree does not cover the six faces of the cube";
  if (shape.depth > deepest_leaf) return "the tree is deeper than " + std::to_string(deepest_leaf) + " levels";
  if (shape.with_witness != proof.cover.witnesses.size())
    return "there is not one witness for each leaf that needs one";
  if (shape.in_region != proof.cover.regions_of.size()) return "there is not one region for each leaf that lies in one";
  for (const int index : proof.cover.regions_of)
    if (index < 0 || index >= static_cast<int>(proof.cover.regions.size()))
      return "a leaf lies in a region that is not there";
  return {};
}

bool is_cell_of_a_face(const Cell& cell) {
  return cell.axis >= 0 && cell.axis < 3 && (cell.sign == 1 || cell.sign == -1);
}

/// On the region's face, and in the region.
bool lies_in(const IVec3<Fine>& chart, const Cell& region) {
  const Vec3<double> centre = region.at(0, 0);
  for (int i = 0; i < 3; ++i) {
    const Fine off = magnitude<Fine>(Fine(chart[i] - Fine(centre[i])));
    if (!(high(off) <= (i == region.axis ? 0 : region.half))) return false;
  }
  return true;
}

class ProofVerifier {
 public:
  ProofVerifier(const Pair& pair, const Proof& proof)
      : pair_(pair), proof_(proof), enclosed_(enclose<Fine>(pair)), framed_(enclosed_, proof.cover.frame) {}

  ProofCheck run() {
    if (!is_positive(framed_.shortest)) {
      fail("the frame is no rotation");
    } else if (proof_.solutions.size() != proof_.cover.regions.size()) {
      fail("there is not one solution for each region");
    } else if (!std::all_of(proof_.cover.regions.begin(), proof_.cover.regions.end(), is_cell_of_a_face)) {
      fail("a region is on no face of the cube");
    } else if (bound_from_above()) {
      check_least();
    }
    if (out_.failure.empty()) {
      out_.overlap.lower = low_as<Real50>(times_power_of_two<Fine>(least_, enclosed_.exponent));
      out_.overlap.upper = high_as<Real50>(times_power_of_two<Fine>(highest_, enclosed_.exponent));
    }
    return std::move(out_);
  }

 private:
  void fail(std::string reason) {
    if (out_.failure.empty()) out_.failure = std::move(reason);
  }

  /// o at any direction is at least the lowest.
  bool bound_from_above() {
    highest_ = overlap_at<Fine>(framed_, proof_.direction.enclosed());
    const bool is_direction = mpfi_bounded_p(highest_.data()) != 0;
    if (!is_direction) fail("the direction is none");
    return is_direction;
  }

  void check_least() {
    switch (proof_.kind) {
      case ProofKind::cover: return check_cover();
      case ProofKind::meridian: return check_meridian();
      case ProofKind::spheres: return check_spheres();
      case ProofKind::apart: return check_apart(proof_.apart);
    }
  }

  void check_cover() {
    fail(find_misshape(proof_));
    if (!(proof_.level >= 0)) fail("the level is below zero");
    if (!out_.failure.empty()) return;
    const FramedPair<OfCover> coarse(enclose<OfCover>(pair_), proof_.cover.frame);
    const CoverProof found = verify_cover<OfCover>(coarse, proof_.cover, proof_.level);
    if (!found.well_formed) return fail("a witness does not lie in its body");
    if (!found.excluded) return fail("a leaf is not above the level, or not in its region");
    least_ = std::min(proof_.level, found.least_open);
    check_regions();
  }

  /// Those that bound a leaf; `bounded` leaves have a witness instead.
  void check_regions() {
    std::vector<bool> bounds(proof_.cover.regions.size(), false);
    auto region = proof_.cover.regions_of.begin();
    for (const Leaf leaf : proof_.cover.tree)
      if (leaf == Leaf::bounded || leaf == Leaf::convex)
        if (const auto index = static_cast<std::size_t>(*region++); leaf == Leaf::convex) bounds[index] = true;
    for (std::size_t i = 0; i < bounds.size(); ++i)
      if (const auto found = bounds[i] ? check_region(i) : std::nullopt; found && is_lower(found->least, least_))
        least_ = found->least;
  }

  struct RegionBound {
    bool holds_minimum;
    Fine value, least;  ///< o at the solution, and its lower bound on the region
  };

  /// o >= value - deficit on the region; nothing, and the proof fails, where that is not so.
  std::optional<RegionBound> check_region(std::size_t index) {
    const Cell& region = proof_.cover.regions[index];
    const IVec3<Fine> chart = proof_.solutions[index].enclosed();
    if (!lies_in(chart, region)) {
      fail(of_region(index) + "the solution lies outside");
      return {};
    }
    const RegionProof<Fine> found = verify_region<Fine>(framed_, region, chart);
    if (!found.convex) {
      fail(of_region(index) + "the overlap may have more than one minimum there");
      return {};
    }
    return RegionBound{found.located, found.value, low_end<Fine>(Fine(found.value - found.deficit))};
  }

  void check_meridian() {
    const MeridianProof<Fine> found = verify_meridian<Fine>(pair_, framed_, proof_.meridian);
    if (!found.well_formed) return fail("the arcs are no half circle, or a witness does not lie in its body");
    if (mpfi_bounded_p(found.least.data()) == 0)
      return fail("the bodies are not of revolution about one line, or an arc is not bounded");
    least_ = found.least;
  }

  void check_spheres() {
    if (!is_sphere(pair_.body1.shape) || !is_sphere(pair_.body2.shape)) return fail("the bodies are no spheres");
    least_ = low_end<Fine>(lowest_overlap_of_spheres<Fine>(enclosed_));
  }

  // -|p1 - p2| is a lower bound of o for any two points. A region holds the stationary direction of bodies apart when it
  // holds one with o < 0, and o is lowest there.
  void check_apart(const Witness& points) {
    if (!(high(highest_) < 0)) return fail("the direction does not separate the bodies");
    if (!proof_.cover.tree.empty() || proof_.cover.regions.size() > 1) return fail("bodies apart need no cover");
    const auto by_points = least_overlap_apart<Fine>(enclosed_, points);
    if (!by_points) return fail("a point does not lie in its body");
    least_ = *by_points;
    if (proof_.cover.regions.empty()) return;
    const auto found = check_region(0);
    if (!found) return;
    if (!found->holds_minimum || !(high(found->value) < 0)) return fail(of_region(0) + "the solution is not located");
    if (is_lower(least_, found->least)) least_ = found->least;
  }

  const Pair& pair_;
  const Proof& proof_;
  const EnclosedPair<Fine> enclosed_;
  const FramedPair<Fine> framed_;
  Fine least_, highest_;  ///< bounds of the lowest overlap
  ProofCheck out_;
};

}  // namespace

ProofCheck verify_proof(const Pair& pair, const Proof& proof) {
  const StandardArithmetic mode;
  return ProofVerifier(pair, proof).run();
}

}  // namespace plumb::reference
