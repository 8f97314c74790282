#include "solver/reference/search/stationary.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "solver/reference/interval/direction_box.hpp"
#include "solver/reference/meter.hpp"
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
DirectionCells all_directions() {
  DirectionCells out{rotation<double>({0.83, 0.31, 0.42, 0.19}), {}};
  for (int face = 0; face < 6; ++face) out.cells.push_back(face_of_cube(face));
  return out;
}

/// The two functionals of a cell's face, their values and slopes at the middle in double.
struct Middle {
  std::array<Vec3<double>, 2> c;
  Eigen::Vector2d value;
  Eigen::Matrix2d slope;
};

/// Cells about the equator of a body of revolution, cut into slices across its axis. Where the axes all but coincide the slopes along the
/// equator are a product of the tilt and of a latitude: they have a sign in slices thinner than the tilt and as long as may be.
template <class I>
class SlicedCells {
 public:
  /// `axes`: those of the two bodies.
  SlicedCells(const ChartedPair<I>& search, std::size_t body, const std::array<int, 2>& axes)
      : axis_(axes[body]), pair_(search.pair, {Mat3<double>::Identity(), static_cast<int>(body)}),
        to_axes_(body == 0 ? search.to_body[0] : IMat3<I>(-search.to_body[1])),
        along_{axis_functional<I>(pair_, axes[0]), axis_functional<I>(pair_, 3 + axes[1])} {}

  /// Whether each slice of the cell is without a stationary direction, by the slope across the equator or along it.
  [[nodiscard]] bool are_excluded(const Cell& cell) const {
    if (cell.half > widest) return false;
    const IVec3<I> box = to_axes_ * box_of<I>(cell, cell.half);
    const double first = low(box[axis_]), last = high(box[axis_]);
    if (!(first < 0 && last > 0)) return false;
    Vec3<double> middle;
    for (int i = 0; i < 3; ++i) middle[i] = (low(box[i]) + high(box[i])) / 2;
    const Functional<I> across = functional<I>(pair_, Vec3<double>::Unit(axis_).cross(middle).normalized());
    int slices = most_slices;
    return is_excluded(box, across, first, last, slices);
  }

 private:
  static constexpr int most_slices = 100;
  static constexpr double widest = 1.0 / 16;

  bool is_excluded(IVec3<I> box, const Functional<I>& across, double first, double last, int& slices) const {
    if (slices-- == 0) return false;
    count_work(nanoseconds_of_a_slice);
    box[axis_] = hull<I>(first, last);
    const DirectionBox<I> directions = direction_box<I>(pair_, box);
    for (const Functional<I>* phi : {&across, &along_[0], &along_[1]})
      if (has_no_zero<I>(value_of<I>(directions, *phi))) return true;
    const double middle = (first + last) / 2;
    return is_excluded(box, across, first, middle, slices) && is_excluded(box, across, middle, last, slices);
  }

  int axis_;
  ChartedPair<I> pair_;  ///< in the body's axes
  IMat3<I> to_axes_;
  std::array<Functional<I>, 2> along_;
};

/// A leaf of the cover: excluded, or inside the region of an isolated pair.
struct CoverLeaf {
  Cell cell;
  int region = -1, sliced = -1;  ///< the latter: which body's axis
  Exclusion exclusion;
};

class StationarySearch {
 public:
  StationarySearch(const Pair& pair, DirectionCells part, const StationaryLimits& limits)
      : limits_(limits), placed_(place<double>(pair)), finer_(place<long double>(pair)), fine_(place<Real50>(pair)),
        isolator_(pair), frame_(part.frame), check_(isolator_.coarse(), {frame_}),
        look_(rounded(isolator_.coarse()), {frame_}), cells_(std::move(part.cells)) {
    for (int axis = 0; axis < 6; ++axis) axes_.push_back(axis_functional<Look>(look_, axis));
    const auto &axis1 = look_.body(0).axis, &axis2 = look_.body(1).axis;
    if (!axis1 || !axis2) return;
    for (std::size_t body = 0; body < 2; ++body) {
      look_sliced_.emplace_back(look_, body, std::array{*axis1, *axis2});
      check_sliced_.emplace_back(check_, body, std::array{*axis1, *axis2});
    }
  }

  StationarySet run() {
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
    count_work(nanoseconds_of_a_stationary_cell);
    CoverLeaf leaf{cell, region_of(cell), -1, {}};
    if (leaf.region < 0) {
      const Middle middle = middle_of(cell);
      if (!exclude(cell, middle, leaf.exclusion) && !exclude_sliced(cell, leaf.sliced)) {
        look_for_solution(cell, middle);
        for (int i = 0; i < 4; ++i) cells_.push_back(cell.quarter(i));
        return;
      }
    }
    leaves_.push_back(leaf);
  }

  /// What the search left is proved here; what does not stand is split.
  void verify_leaves() {
    for (const CoverLeaf& leaf : leaves_)
      if (!stands(leaf))
        for (int i = 0; i < 4; ++i) cells_.push_back(leaf.cell.quarter(i));
    leaves_.clear();
  }

  [[nodiscard]] bool stands(const CoverLeaf& leaf) const {
    if (leaf.region >= 0)
      return is_inside_region<Check>(check_, leaf.cell, found_[static_cast<std::size_t>(leaf.region)]);
    if (leaf.sliced >= 0) return check_sliced_[static_cast<std::size_t>(leaf.sliced)].are_excluded(leaf.cell);
    return holds<Check>(check_, leaf.cell, leaf.exclusion);
  }

  [[nodiscard]] bool exclude_sliced(const Cell& cell, int& body) const {
    for (std::size_t i = 0; i < look_sliced_.size(); ++i) {
      if (!look_sliced_[i].are_excluded(cell)) continue;
      body = static_cast<int>(i);
      return true;
    }
    return false;
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
    const auto works = [&](const Functional<Look>& phi) {
      out.by_slopes = false;
      if (has_no_zero<Look>(value_of<Look>(box, phi))) return true;
      out.by_slopes = true;
      Look value = value_of<Look>(at, phi);
      for (const int step : {1, 2}) value += slope_of<Look>(look_, box, phi, (cell.axis + step) % 3) * reach;
      return has_no_zero<Look>(value);
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
    const std::optional<ChartPair<Real50>> found = polished_to_digits(rough, normal);
    if (!found) return;
    const Vec3<double> refined = chart_residual<Real50>(fine_, {}, *found).normal1.cast<double>();
    if (is_known(refined)) return;
    if (const auto isolated = isolator_.isolate(*found))
      found_.push_back(*isolated);
    else
      out_.unproved.push_back(refined);
  }

  /// First in 19 digits, which is soon done where it leads nowhere or to what is known.
  [[nodiscard]] std::optional<ChartPair<Real50>> polished_to_digits(const LocalSolution<double>& rough,
                                                                    const Vec3<double>& normal) const {
    count_work(nanoseconds_of_a_local_solve);
    const StationaryPoint<long double> finer = polished<long double>(finer_, rough);
    if (finer.solved && is_known(finer.normal.cast<double>())) return {};
    if (finer.solved || look_sliced_.empty())  // of revolution it leads nowhere else
      if (const StationaryPoint<Real50> found = polished<Real50>(fine_, rough); found.solved) return found.at;
    return isolator_.zero_near(normal);
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
  const PlacedPair<long double> finer_;
  const PlacedPair<Real50> fine_;
  const Isolator isolator_;
  const Mat3<double> frame_;
  const ChartedPair<Check> check_;
  const ChartedPair<Look> look_;
  std::vector<Functional<Look>> axes_;          ///< of both bodies
  std::vector<SlicedCells<Look>> look_sliced_;  ///< by both bodies' axes, of bodies of revolution
  std::vector<SlicedCells<Check>> check_sliced_;
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
  return StationarySearch(pair, all_directions(), limits).run();
}

StationarySet find_stationary(const Pair& pair, DirectionCells part, const StationaryLimits& limits) {
  const StandardArithmetic mode;
  return StationarySearch(pair, std::move(part), limits).run();
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
