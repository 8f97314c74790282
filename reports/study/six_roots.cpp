#include "reports/study/six_roots.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <deque>

#include "reports/study/six_isolation.hpp"

namespace plumb::reports {
namespace {

using namespace reference;

constexpr double smallest_cell = 0x1p-46;
constexpr double last_step = 1e-9;  // of Newton's method in double: more digits go on from there
constexpr unsigned all_systems = (1u << system_count) - 1;

/// A cell, and the systems that may have a zero in it.
struct OpenCell {
  Cell cell;
  unsigned systems;
};

/// One system's F at a cell's middle and its Jacobian there and over the cell.
struct LocalSystem {
  IVec2<Look> value;
  IMat2<Look> slopes;
  Eigen::Vector2d rough_value;
  Eigen::Matrix2d inverse;
};

[[nodiscard]] bool has_no_zero(const Look& x) {
  return low(x) > 0 || high(x) < 0;
}

[[nodiscard]] Look intersection(const Look& a, const Look& b) {
  return {std::max(low(a), low(b)), std::min(high(a), high(b))};
}

/// What is known of x1, x2 or d in a cell.
struct InCell {
  OverBox<Look> middle, box;
};

/// The value also by middle and slopes.
[[nodiscard]] InCell support_in(const SupportMap<Look>& map, const Cell& cell) {
  InCell out{support_over<Look>(map, box_of<Look>(cell, 0), cell.axis),
             support_over<Look>(map, box_of<Look>(cell, cell.half), cell.axis)};
  const Look reach(-cell.half, cell.half);
  for (int i = 0; i < 3; ++i)
    out.box.value[i] =
        intersection(out.box.value[i], out.middle.value[i] + out.box.slope(i, 0) * reach + out.box.slope(i, 1) * reach);
  return out;
}

[[nodiscard]] InCell difference_in(const InCell& x2, const InCell& x1) {
  return {difference<Look>(x2.middle, x1.middle), difference<Look>(x2.box, x1.box)};
}

/// By F itself over the cell.
[[nodiscard]] bool excludes_by_value(const SixSystem& system, const Face& face, const Cell& cell, const InCell& d) {
  const IVec2<Look> value = value_of<Look>(system, face, box_of<Look>(cell, cell.half), d.box);
  return has_no_zero(value[0]) || has_no_zero(value[1]);
}

[[nodiscard]] LocalSystem local_system(const SixSystem& system, const Face& face, const Cell& cell, const InCell& d) {
  const IVec3<Look> middle = box_of<Look>(cell, 0), box = box_of<Look>(cell, cell.half);
  LocalSystem out;
  out.value = value_of<Look>(system, face, middle, d.middle);
  out.slopes = jacobian_of<Look>(system, face, box, d.box);
  out.rough_value = middles(out.value);
  out.inverse = middles(jacobian_of<Look>(system, face, middle, d.middle)).inverse();
  return out;
}

/// By combinations of F at the middle plus its slopes: along F, and by Newton's preconditioner.
[[nodiscard]] bool excludes_by_slopes(const LocalSystem& local, double half) {
  const Look reach(-half, half);
  const std::array<Eigen::Vector2d, 3> tries{local.rough_value, local.inverse.row(0), local.inverse.row(1)};
  return std::any_of(tries.begin(), tries.end(), [&](const Eigen::Vector2d& weights) {
    const Look a(weights[0]), b(weights[1]);
    Look sum = a * local.value[0] + b * local.value[1];
    for (const int j : {0, 1}) sum += (a * local.slopes(0, j) + b * local.slopes(1, j)) * reach;
    return weights.allFinite() && has_no_zero(sum);
  });
}

class SixRootSearch {
 public:
  SixRootSearch(const Pair& pair, const SixRootLimits& limits) : limits_(limits), isolator_(pair) {}

  SixRoots run() {
    for (int face = 0; face < 6; ++face) cells_.push_back({face_of_cube(face), all_systems});
    while (!cells_.empty() && may_go_on(cells_.front().cell)) {
      const OpenCell open = cells_.front();
      cells_.pop_front();
      visit(open);
    }
    report();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool may_go_on(const Cell& next) {
    if (++out_.cells > limits_.cells)
      out_.reason = "cell budget: directions are left open";
    else if (next.half < smallest_cell)
      out_.reason = "a cell as small as rounding allows is left open";
    else if (unproved_ > limits_.unproved)
      out_.reason = "many solutions without a proof: a continuum, or nearly one, or points that meet (D = 0)";
    return out_.reason.empty();
  }

  void visit(const OpenCell& open) {
    const InCell x1 = support_in(isolator_.look().map1, open.cell);
    unsigned left = 0;
    for (const unsigned which : {0u, 1u}) {
      const unsigned systems = open.systems & (0xfu << (4 * which));
      if (systems == 0) continue;
      const InCell d = difference_in(support_in(isolator_.look().map2[which], open.cell), x1);
      for (int i = 0; i < system_count; ++i)
        if ((systems >> i) % 2 != 0 && is_left(open.cell, {i}, d)) left |= 1u << i;
    }
    if (left == 0) return;
    for (int i = 0; i < 4; ++i) cells_.push_back({open.cell.quarter(i), left});
  }

  [[nodiscard]] bool is_left(const Cell& cell, const SixSystem& system, const InCell& d) {
    const Face face{cell.axis, cell.sign};
    if (is_known(system, cell) || excludes_by_value(system, face, cell, d)) return false;
    const LocalSystem local = local_system(system, face, cell, d);
    if (excludes_by_slopes(local, cell.half)) return false;
    look_for_solution(cell, system, local);
    return !is_known(system, cell);
  }

  [[nodiscard]] bool is_known(const SixSystem& system, const Cell& cell) const {
    return std::any_of(regions_.begin(), regions_.end(),
                       [&](const Region& region) { return contains(region, system, cell); });
  }

  /// Where Newton's steps from the middle end near the cell, a solution is isolated unless it is known.
  void look_for_solution(const Cell& cell, const SixSystem& system, const LocalSystem& local) {
    const Face face{cell.axis, cell.sign};
    const double near = 3;  // times the cell's half
    Vec3<double> v = cell.at(0, 0);
    Eigen::Vector2d step = local.inverse * local.rough_value;
    const int limit = 12;
    for (int i = 0; i < limit && step.lpNorm<Eigen::Infinity>() > last_step; ++i) {
      for (const int k : {0, 1}) v[face.coordinate(k)] -= step[k];
      if (!((v - cell.at(0, 0)).lpNorm<Eigen::Infinity>() <= near * cell.half)) return;
      const IVec3<Look> at = enclosed<Look>(v);
      const OverBox<Look> d = gap_over<Look>(isolator_.look(), system, at, face.axis);
      step = middles(jacobian_of<Look>(system, face, at, d)).inverse() * middles(value_of<Look>(system, face, at, d));
    }
    const bool arrived = step.lpNorm<Eigen::Infinity>() <= last_step;
    if (arrived && !is_known(system, {face.axis, face.sign, v[face.coordinate(0)], v[face.coordinate(1)], 0}))
      isolate(system, face, v);
  }

  void isolate(const SixSystem& system, const Face& face, const Vec3<double>& near) {
    const auto isolated = isolator_.isolate(system, face, near);
    if (!isolated) {
      ++unproved_;
      return;
    }
    regions_.push_back(isolated->region);
    const bool again =
        std::any_of(found_.begin(), found_.end(), [&](const Isolated& i) { return is_same(i, *isolated); });
    if (!again) found_.push_back(*isolated);
  }

  void report() {
    while (!found_.empty()) {
      const Isolated one = found_.front();
      const auto rest = std::stable_partition(found_.begin(), found_.end(),
                                              [&](const Isolated& i) { return cannot_be_told_apart(one, i); });
      out_.roots.push_back(isolator_.report({found_.begin(), rest}));
      found_.erase(found_.begin(), rest);
    }
    std::stable_sort(out_.roots.begin(), out_.roots.end(), [](const SixRoot& a, const SixRoot& b) {
      return a.kind != b.kind ? a.kind < b.kind : a.distance < b.distance;
    });
    out_.complete = out_.reason.empty();
  }

  const SixRootLimits limits_;
  const SixIsolator isolator_;
  std::deque<OpenCell> cells_;
  std::vector<Region> regions_;
  std::vector<Isolated> found_;
  int unproved_ = 0;
  SixRoots out_;
};

[[nodiscard]] bool is_ellipsoid(const Body& body) {
  return body.shape.n1 == 2 && body.shape.n2 == 2;
}

}  // namespace

std::string_view name(SixRootKind kind) {
  constexpr std::array<std::string_view, 5> names{"common normal", "common normal, apart", "signs", "z", "both"};
  return names[static_cast<std::size_t>(kind)];
}

SixRootKind kind_of(const SixBranch& branch) {
  const auto& [tau, s] = branch;
  const bool xy = s[0] < 0 && s[1] < 0, z = s[2] < 0 && tau < 0;
  if (xy) return z ? SixRootKind::common_normal : SixRootKind::z;
  if (z) return SixRootKind::signs;
  return tau < 0 && s[0] > 0 && s[1] > 0 ? SixRootKind::common_normal_apart : SixRootKind::both;
}

SixRoots find_six_roots(const Pair& pair, const SixRootLimits& limits) {
  SixRoots refused;
  refused.reason = find_input_error(pair).reason;
  if (refused.reason.empty() && !(is_ellipsoid(pair.body1) && is_ellipsoid(pair.body2)))
    refused.reason = "exponents other than 2 are not supported";
  return refused.reason.empty() ? SixRootSearch(pair, limits).run() : refused;
}

std::optional<std::size_t> find_root(const SixRoots& set, const Vec3<double>& point1, const Vec3<double>& point2,
                                     double length) {
  std::optional<std::size_t> best;
  double least = length;
  for (std::size_t i = 0; i < set.roots.size(); ++i) {
    const double off1 = (point1 - set.roots[i].point1.cast<double>()).norm(),
                 off2 = (point2 - set.roots[i].point2.cast<double>()).norm();
    if (!(std::max(off1, off2) <= least)) continue;
    least = std::max(off1, off2);
    best = i;
  }
  return best;
}

}  // namespace plumb::reports
