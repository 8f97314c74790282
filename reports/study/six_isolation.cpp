#include "reports/study/six_isolation.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace plumb::reports {
namespace {

using namespace reference;

constexpr int widest_level = 2, narrowest_level = 44;  // of the squares tried, half = 2^-level

/// An approximate inverse, exact as it stands; NaN where there is none.
template <class I>
IMat2<I> inverse_of(const IMat2<I>& jacobian) {
  const Eigen::Matrix2d inverse = middles(jacobian).inverse();
  IMat2<I> out;
  for (int i = 0; i < 4; ++i) out(i / 2, i % 2) = I(inverse(i / 2, i % 2));
  return out;
}

/// |I - Y J| < 1 for all J in the box: two zeros would give J (x - y) = 0 for one of them.
bool has_one_zero_at_most(const IMat2<Look>& y, const IMat2<Look>& jacobian) {
  const IMat2<Look> product = y * jacobian;
  for (const int i : {0, 1}) {
    const Look sum = magnitude<Look>(Look(Look(i == 0 ? 1.0 : 0.0) - product(i, 0))) +
                     magnitude<Look>(Look(Look(i == 1 ? 1.0 : 0.0) - product(i, 1)));
    if (!(high(sum) < 1)) return false;
  }
  return true;
}

/// A box of a face's coordinates inside a square of that face.
template <class I>
bool is_inside(const IVec3<I>& v, const Cell& cell) {
  const Face face{cell.axis, cell.sign};
  const std::array<double, 2> middle{cell.u, cell.v};
  for (const int i : {0, 1}) {
    const I off = magnitude<I>(I(v[face.coordinate(i)] - I(middle[static_cast<std::size_t>(i)])));
    if (!(high(off) <= cell.half)) return false;
  }
  return true;
}

/// Of the first box that Krawczyk's operator is tried on, by a coordinate's last step of Newton.
double first_radius(const Fine& newton) {
  return 4 * high(magnitude<Fine>(newton)) + 1e-60;
}

}  // namespace

bool contains(const Region& region, const SixSystem& system, const Cell& cell) {
  return region.system.index == system.index && region.cell.axis == cell.axis && region.cell.sign == cell.sign &&
         is_inside<Look>(box_of<Look>(cell, cell.half), region.cell);
}

bool is_same(const Isolated& known, const Isolated& found) {
  if (known.region.system.index != found.region.system.index) return false;
  const Cell& cell = known.region.cell;
  const Fine across = with_sign<Fine>(found.v[cell.axis], cell.sign);
  if (!is_positive(across)) return false;
  IVec3<Fine> v;
  for (int i = 0; i < 3; ++i) v[i] = found.v[i] / across;
  return is_inside<Fine>(v, cell);
}

bool cannot_be_told_apart(const Isolated& a, const Isolated& b) {
  const auto overlap = [](const IVec3<Fine>& x, const IVec3<Fine>& y) {
    for (int i = 0; i < 3; ++i)
      if (is_below<Fine>(x[i], y[i]) || is_below<Fine>(y[i], x[i])) return false;
    return true;
  };
  return overlap(a.point1, b.point1) && overlap(a.point2, b.point2);
}

SixIsolator::SixIsolator(const Pair& pair)
    : pair_(pair), fine_enclosure_(enclose<Fine>(pair)), fine_(fine_enclosure_), look_(enclose<Look>(pair)) {}

std::optional<Isolated> SixIsolator::isolate(const SixSystem& system, const Face& face,
                                             const Vec3<double>& near) const {
  const auto v = contract(system, face, refined(system, face, near));
  if (!v) return {};
  const auto region = region_about(system, face, *v);
  if (!region) return {};
  Isolated out{*region, *v, {}, {}, {}, {}};
  return set_solution(out) ? std::optional(out) : std::nullopt;
}

/// Newton's method; each Jacobian to the double gains the digits of double.
Vec3<Real50> SixIsolator::refined(const SixSystem& system, const Face& face, const Vec3<double>& near) const {
  const int steps = 6;
  Vec3<Real50> at = near.cast<Real50>();
  for (int i = 0; i < steps; ++i) {
    const IVec3<Fine> v = enclosed<Fine>(at);
    const OverBox<Fine> d = gap_over<Fine>(fine_, system, v, face.axis);
    const IVec2<Fine> step =
        inverse_of<Fine>(jacobian_of<Fine>(system, face, v, d)) * value_of<Fine>(system, face, v, d);
    for (const int k : {0, 1}) at[face.coordinate(k)] -= middle<Real50>(step[k]);
  }
  return at;
}

/// A box that holds a zero, by Krawczyk's operator.
std::optional<IVec3<Fine>> SixIsolator::contract(const SixSystem& system, const Face& face,
                                                 const Vec3<Real50>& at) const {
  if (!std::all_of(at.begin(), at.end(), [](const Real50& x) { return isfinite(x); })) return {};
  const IVec3<Fine> v = enclosed<Fine>(at);
  const OverBox<Fine> d = gap_over<Fine>(fine_, system, v, face.axis);
  const IMat2<Fine> y = inverse_of<Fine>(jacobian_of<Fine>(system, face, v, d));
  const IVec2<Fine> newton = y * value_of<Fine>(system, face, v, d);
  std::array<double, 2> half{first_radius(newton[0]), first_radius(newton[1])};
  for (int attempt = 0; attempt < 6; ++attempt, half[0] *= 1024, half[1] *= 1024) {
    const std::array<Fine, 2> reach{hull<Fine>(-half[0], half[0]), hull<Fine>(-half[1], half[1])};
    IVec3<Fine> box = v, next = v;
    for (const int k : {0, 1}) box[face.coordinate(k)] += reach[static_cast<std::size_t>(k)];
    const IMat2<Fine> product = y * jacobian_of<Fine>(system, face, box, gap_over<Fine>(fine_, system, box, face.axis));
    bool inside = true;
    for (const int k : {0, 1}) {
      Fine step = -newton[k];
      for (const int l : {0, 1})
        step += (Fine(k == l ? 1.0 : 0.0) - product(k, l)) * reach[static_cast<std::size_t>(l)];
      inside &= high(magnitude<Fine>(step)) < half[static_cast<std::size_t>(k)];
      next[face.coordinate(k)] += step;
    }
    if (inside) return next;
  }
  return {};
}

/// The widest of the squares tried.
std::optional<Region> SixIsolator::region_about(const SixSystem& system, const Face& face, const IVec3<Fine>& v) const {
  const Vec3<double> at = middles(v);
  const double a = at[face.coordinate(0)], b = at[face.coordinate(1)];
  const auto jacobian_over = [&](double half) {
    const IVec3<Look> box = box_of<Look>({face.axis, face.sign, a, b, half}, half);
    return jacobian_of<Look>(system, face, box, gap_over<Look>(look_, system, box, face.axis));
  };
  const IMat2<Look> y = inverse_of<Look>(jacobian_over(0));
  for (int level = widest_level; level < narrowest_level; ++level) {
    const Cell cell{face.axis, face.sign, a, b, std::ldexp(1, -level)};
    if (has_one_zero_at_most(y, jacobian_over(cell.half)) && is_inside<Fine>(v, cell)) return Region{system, cell};
  }
  return {};
}

/// Normal, points and the sign of d.S n, which picks the branch; false where that is open (D = 0).
bool SixIsolator::set_solution(Isolated& out) const {
  const SixSystem& system = out.region.system;
  const int axis = out.region.cell.axis;
  out.point1 = support_over<Fine>(fine_.map1, out.v, axis).value;
  out.point2 = support_over<Fine>(fine_.map2[static_cast<std::size_t>(system.index / 4)], out.v, axis).value;
  const Fine length = length_of<Fine>(out.v);
  Fine along(0.0);
  for (int i = 0; i < 3; ++i) {
    out.normal1[i] = out.v[i] / length;
    along += with_sign<Fine>(Fine((out.point2[i] - out.point1[i]) * out.v[i]), system.sign(i));
  }
  if (!is_positive(along) && !is_positive(Fine(-along))) return false;
  const int turn = is_positive(along) ? 1 : -1;
  out.branch = {system.tau(), {turn * system.sign(0), turn * system.sign(1), turn * system.sign(2)}};
  return true;
}

SixRoot SixIsolator::report(const std::vector<Isolated>& shared) const {
  const auto middle_of = [](const IVec3<Fine>& x) {
    return Vec3<Real50>(middle<Real50>(x[0]), middle<Real50>(x[1]), middle<Real50>(x[2]));
  };
  const Isolated& one = shared.front();
  const IVec3<Fine> x1 = fine_enclosure_.to_world_point(one.point1, pair_),
                    x2 = fine_enclosure_.to_world_point(one.point2, pair_);
  SixRoot out;
  for (const Isolated& i : shared) {
    out.branches.push_back(i.branch);
    out.kind = std::min(out.kind, kind_of(i.branch));
  }
  const IVec3<Fine> d = one.point2 - one.point1, normal2 = turned<Fine>(one.normal1, one.branch.tau);
  const Fine length = length_of<Fine>(d);
  out.normal1 = middle_of(one.normal1);
  out.normal2 = middle_of(normal2);
  out.point1 = middle_of(x1);
  out.point2 = middle_of(x2);
  out.distance = middle<Real50>(times_power_of_two<Fine>(length, fine_enclosure_.exponent));
  out.residual =
      middle_of({d[0] / length + one.normal1[0], d[1] / length - normal2[1], d[2] / length + one.normal1[2]});
  out.normal_radius = std::max(farthest(one.normal1, out.normal1), farthest(normal2, out.normal2));
  out.points_radius = std::max(farthest(x1, out.point1), farthest(x2, out.point2));
  return out;
}

}  // namespace plumb::reports
