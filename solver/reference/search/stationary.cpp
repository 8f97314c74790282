#include "solver/reference/search/stationary.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <deque>

#include "solver/reference/interval/direction_box.hpp"
#include "solver/reference/search/isolation.hpp"
#include "solver/reference/search/stationary_point.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

using namespace reference;
using Look = RoughInterval;
using Check = Interval18;

constexpr double smallest_cell = 0x1p-46;

/// Generic, so that no edge of a cell follows a plane of symmetry.
Mat3<double> search_frame() {
  return rotation<double>({0.83, 0.31, 0.42, 0.19});
}

/// The two functionals of a cell's face, their values and slopes at the middle in double.
struct Middle {
  std::array<Vec3<double>, 2> c;
  Eigen::Vector2d value;
  Eigen::Matrix2d slope;
};

/// A leaf of the cover: excluded, or inside the region of an isolated pair.
struct CoverLeaf {
  Cell cell;
  int region = -1;
  Exclusion exclusion;
};

class StationarySearch {
 public:
  StationarySearch(const Pair& pair, const StationaryLimits& limits)
      : limits_(limits), placed_(place<double>(pair)), fine_(place<Real50>(pair)), isolator_(pair),
        frame_(search_frame()), check_(isolator_.coarse(), {frame_}), look_(rounded(isolator_.coarse()), {frame_}) {
    for (int axis = 0; axis < 6; ++axis) axes_[static_cast<std::size_t>(axis)] = axis_functional<Look>(look_, axis);
  }

  StationarySet run() {
    for (int face = 0; face < 6; ++face) cells_.push_back(face_of_cube(face));
    while (!cells_.empty() && out_.reason.empty()) {
      search();
      if (out_.reason.empty()) verify_leaves();
    }
    report();
    return std::move(out_);
  }

 private:
  /// Cells in the order of their size until each is a leaf or a budget ends.
  void search() {
    while (!cells_.empty()) {
      const Cell cell = cells_.front();
      if (++out_.cells > limits_.cells)
        out_.reason = "cell budget: directions are left open";
      else if (cell.half < smallest_cell)
        out_.reason = "a cell as small as rounding allows is left open";
      else if (static_cast<int>(out_.unproved.size()) > limits_.unproved)
        out_.reason = "many stationary directions without a proof: a continuum, or nearly one";
      if (!out_.reason.empty()) return;
      cells_.pop_front();
      visit(cell);
    }
  }

  void visit(const Cell& cell) {
    CoverLeaf leaf{cell, region_of(cell), {}};
    if (leaf.region < 0) {
      const Middle middle = middle_of(cell);
      if (!exclude(cell, middle, leaf.exclusion)) {
        look_for_solution(cell, middle);
        for (int i = 0; i < 4; ++i) cells_.push_back(cell.quarter(i));
        return;
      }
    }
    leaves_.push_back(leaf);
  }

  /// What the search left is proved here; what does not stand is split.
  void verify_leaves() {
    for (const CoverLeaf& leaf : leaves_) {
      const bool stands =
          leaf.region >= 0 ? is_inside_region<Check>(check_, leaf.cell, found_[static_cast<std::size_t>(leaf.region)])
                           : holds<Check>(check_, leaf.cell, leaf.exclusion);
      if (!stands)
        for (int i = 0; i < 4; ++i) cells_.push_back(leaf.cell.quarter(i));
    }
    leaves_.clear();
  }

  [[nodiscard]] int region_of(const Cell& cell) const {
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (is_inside_region<Look>(look_, cell, found_[i])) return static_cast<int>(i);
    return -1;
  }

  [[nodiscard]] Middle middle_of(const Cell& cell) const {
    const int first = (cell.axis + 1) % 3, second = (cell.axis + 2) % 3;
    Middle out{{-frame_.col(second), frame_.col(first)}, {}, {}};
    const DirectionBox<Look> at = direction_box<Look>(look_, box_of<Look>(cell, 0));
    for (int i = 0; i < 2; ++i) {
      const Functional<Look> phi = functional<Look>(look_, out.c[static_cast<std::size_t>(i)]);
      out.value[i] = value_of<Look>(at, phi).lower;
      out.slope(i, 0) = slope_of<Look>(look_, at, phi, first).lower;
      out.slope(i, 1) = slope_of<Look>(look_, at, phi, second).lower;
    }
    return out;
  }

  /// Tries the functionals that have a chance: by Newton's preconditioner, along the gradient, and the bodies' axes.
  [[nodiscard]] bool exclude(const Cell& cell, const Middle& middle, Exclusion& out) const {
    const DirectionBox<Look> box = direction_box<Look>(look_, box_of<Look>(cell, cell.half));
    const DirectionBox<Look> at = direction_box<Look>(look_, box_of<Look>(cell, 0));
    const Look reach(-cell.half, cell.half);
    const auto has_no_zero = [](const Look& x) { return x.lower > 0 || x.upper < 0; };
    const auto works = [&](const Functional<Look>& phi) {
      out.by_slopes = false;
      if (has_no_zero(value_of<Look>(box, phi))) return true;
      out.by_slopes = true;
      Look value = value_of<Look>(at, phi);
      for (const int step : {1, 2}) value += slope_of<Look>(look_, box, phi, (cell.axis + step) % 3) * reach;
      return has_no_zero(value);
    };
    const Eigen::Matrix2d inverse = middle.slope.inverse();
    const std::array<Eigen::Vector2d, 3> tries{middle.value, inverse.row(0), inverse.row(1)};
    for (const Eigen::Vector2d& weights : tries) {
      const Vec3<double> c = weights[0] * middle.c[0] + weights[1] * middle.c[1];
      if (!c.allFinite() || !(c.norm() > 0)) continue;
      out.c = c / c.norm();
      if (works(functional<Look>(look_, out.c))) return true;
    }
    for (out.axis = 0; out.axis < 6; ++out.axis)
      if (works(axes_[static_cast<std::size_t>(out.axis)])) return true;
    out.axis = -1;
    return false;
  }

  /// Where Newton's step from the middle of a small cell ends in it, there may be a solution that is not yet known. Across a
  /// flat face the step says little: now and then a cell is tried without it.
  void look_for_solution(const Cell& cell, const Middle& middle) {
    if (cell.half > 0.25) return;
    Eigen::Vector2d step = -(middle.slope.inverse() * middle.value) / cell.half;
    if (!(step.cwiseAbs().maxCoeff() <= 1.5)) {
      const int level = -std::ilogb(cell.half);
      if (level < 6 || level % 4 != 0) return;
      step.setZero();
    }
    const Vec3<double> direction = (frame_ * cell.at(step[0], step[1])).normalized();
    const auto near = [&](const Vec3<double>& other) { return (direction - other).norm() < 3 * cell.half; };
    if (std::any_of(out_.unproved.begin(), out_.unproved.end(), near) || is_known(direction)) return;
    const LocalSolution<double> rough = solve_from_direction<double>(placed_, {}, direction);
    if (!(rough.residual < usable_residual)) return;
    const Vec3<double> normal = chart_residual<double>(placed_, {}, rough.at).normal1;
    const auto same = [&](const Vec3<double>& other) { return (normal - other).norm() < 1e-9; };
    if (is_known(normal) || std::any_of(out_.unproved.begin(), out_.unproved.end(), same)) return;
    const StationaryPoint<Real50> found = polished<Real50>(fine_, rough);
    if (!found.solved) return;
    const Vec3<double> refined = found.normal.cast<double>();
    if (is_known(refined)) return;
    if (const auto isolated = isolator_.isolate(found.at))
      found_.push_back(*isolated);
    else
      out_.unproved.push_back(refined);
  }

  [[nodiscard]] bool is_known(const Vec3<double>& direction) const {
    return std::any_of(found_.begin(), found_.end(),
                       [&](const Isolated& i) { return lies_in_region(look_.pair, direction, i); });
  }

  void report() {
    int sum = 0;
    for (const Isolated& i : found_) {
      out_.pairs.push_back(i.pair);
      sum += i.pair.kind == StationaryKind::saddle ? -1 : 1;
    }
    std::stable_sort(out_.pairs.begin(), out_.pairs.end(),
                     [](const auto& a, const auto& b) { return a.overlap_lower < b.overlap_lower; });
    out_.complete = out_.reason.empty();
    out_.euler = sum == 2;
    for (const Cell& cell : cells_) out_.open.push_back((frame_ * cell.at(0, 0)).normalized());
  }

  const StationaryLimits limits_;
  const PlacedPair<double> placed_;
  const PlacedPair<Real50> fine_;
  const Isolator isolator_;
  const Mat3<double> frame_;
  const ChartedPair<Check> check_;
  const ChartedPair<Look> look_;
  std::array<Functional<Look>, 6> axes_;
  std::deque<Cell> cells_;
  std::vector<CoverLeaf> leaves_;
  std::vector<Isolated> found_;
  StationarySet out_;
};

}  // namespace

std::string_view name(StationaryKind kind) {
  switch (kind) {
    case StationaryKind::minimum: return "minimum";
    case StationaryKind::saddle: return "saddle";
    case StationaryKind::maximum: break;
  }
  return "maximum";
}

StationarySet find_stationary(const Pair& pair, const StationaryLimits& limits) {
  const StandardArithmetic mode;
  return StationarySearch(pair, limits).run();
}

std::optional<std::size_t> find_hit(const StationarySet& set, const Vec3<double>& normal, double overlap, double angle,
                                    double length) {
  const StandardArithmetic mode;
  std::optional<std::size_t> best;
  double least = angle;
  const Vec3<double> n = normal.normalized();
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    const StationaryPair& pair = set.pairs[i];
    const Vec3<double> other = pair.normal.cast<double>();
    const double off = std::atan2(n.cross(other).norm(), n.dot(other));
    const bool level = overlap >= static_cast<double>(pair.overlap_lower) - length &&
                       overlap <= static_cast<double>(pair.overlap_upper) + length;
    if (!level || !(off <= least)) continue;
    least = off;
    best = i;
  }
  return best;
}

}  // namespace plumb
