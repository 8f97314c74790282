// The one list of simplifications, and the simpler cases that they make of one: legal, and of a lower cost.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "properties/generators/described.hpp"
#include "properties/generators/families.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

/// 0 for 0, 1 for 1, otherwise the digits of the shortest decimal and the size of its exponent.
int cost(double x) {
  if (x == 0) return 0;
  if (x == 1) return 1;
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(x), std::chars_format::scientific);
  char* const mantissa_end = std::find(text.data(), end, 'e');
  const auto digits = static_cast<int>(std::count_if(text.data(), mantissa_end, [](char c) { return c != '.'; }));
  const auto exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
  return 2 + 2 * digits + std::abs(exponent) + (x < 0 ? 1 : 0);
}

int cost(const Superellipsoid<double>& shape) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) {
    bool repeated = false;
    for (int j = 0; j < i; ++j) repeated = repeated || shape.semi_axes[i] == shape.semi_axes[j];
    sum += repeated ? 1 : cost(shape.semi_axes[i]) + 4;
  }
  for (const double n : {shape.n1, shape.n2}) sum += n == 2 ? 0 : 4 + cost(n);
  return sum;
}

bool same(const Superellipsoid<double>& a, const Superellipsoid<double>& b) {
  return a.semi_axes == b.semi_axes && a.n1 == b.n1 && a.n2 == b.n2;
}

bool same(const Pair& a, const Pair& b) {
  const auto equal = [](const Body& x, const Body& y) {
    return same(x.shape, y.shape) && x.position == y.position && x.quaternion == y.quaternion;
  };
  return equal(a.body1, b.body1) && equal(a.body2, b.body2) && a.motion == b.motion;
}

int cost_of_rotations(const Described& d) {
  int sum = 0;
  if (d.euler_deg) {
    for (const Vec3<double>& angles : *d.euler_deg)
      for (const double x : angles) sum += cost(x);
    return sum;
  }
  const auto &first = d.pair.body1.quaternion, &second = d.pair.body2.quaternion;
  for (const double x : first) sum += cost(x);
  for (const double x : second) sum += second == first ? 0 : cost(x);
  return sum;
}

/// Angles of a quaternion in X-convention, rounded to a number of degrees, as a quaternion again.
std::array<double, 4> with_round_angles(const std::array<double, 4>& q, double step_degrees) {
  const double step = step_degrees * std::acos(-1.0) / 180;
  const Mat3<double> r = rotation<double>(q);
  const double theta = std::acos(std::clamp(r(2, 2), -1.0, 1.0));
  const bool upright = std::hypot(r(2, 0), r(2, 1)) < 1e-12;
  const double phi = upright ? std::atan2(r(1, 0), r(0, 0)) : std::atan2(r(0, 2), -r(1, 2));
  const double psi = upright ? 0 : std::atan2(r(2, 0), r(2, 1));
  const auto snap = [&](double angle) { return std::round(angle / step) * step; };
  std::array<double, 4> out = quaternion_from_euler_zxz<double>({snap(phi), snap(theta), snap(psi)});
  for (double& x : out) x = std::abs(x) < 1e-15 ? 0 : x;  // cos 90 degrees
  return out;
}

/// Divided by its largest component, which makes round rotations short.
std::array<double, 4> with_largest_one(std::array<double, 4> q) {
  const double largest =
      *std::max_element(q.begin(), q.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (double& x : q) x /= largest;
  return q;
}

class List {
 public:
  void add(Simplification change) { out_.push_back(std::move(change)); }

  /// The same change on both bodies at once, then on each alone.
  void add_for_bodies(const std::function<void(Body&)>& change) {
    add([=](Described& d) { change(d.pair.body1), change(d.pair.body2); });
    add([=](Described& d) { change(d.pair.body1); });
    add([=](Described& d) { change(d.pair.body2); });
  }

  /// Of the orientations as angles, alike.
  void add_for_angles(const std::function<void(Vec3<double>&)>& change) {
    const auto on = [=](bool first, bool second) -> Simplification {
      return [=](Described& d) {
        if (d.euler_deg && first) change((*d.euler_deg)[0]);
        if (d.euler_deg && second) change((*d.euler_deg)[1]);
      };
    };
    for (const auto& [first, second] : {std::pair(true, true), {true, false}, {false, true}}) add(on(first, second));
  }

  void add_for_place(const std::function<void(Vec3<double>&)>& change) {
    add([=](Described& d) {
      if (d.place) change(*d.place);
    });
  }

  [[nodiscard]] std::vector<Simplification> take() { return std::move(out_); }

 private:
  std::vector<Simplification> out_;
};

void add_whole_pair(List& out) {
  out.add([](Described& d) { d.pair.body2.shape = d.pair.body1.shape; });
  out.add([](Described& d) { d.pair.body1.shape = d.pair.body2.shape; });
  out.add([](Described& d) {
    d.pair.body2.position -= d.pair.body1.position;
    d.pair.body1.position.setZero();
  });
  out.add([](Described& d) {  // the unit of length
    const double size = size_of(d.pair);
    for (Body* body : {&d.pair.body1, &d.pair.body2}) {
      body->shape.semi_axes /= size;
      body->position /= size;
    }
  });
}

void add_shapes(List& out) {
  out.add_for_bodies([](Body& b) { b.shape = {Vec3<double>::Constant(b.shape.semi_axes.maxCoeff()), 2, 2}; });
  out.add_for_bodies([](Body& b) { b.shape.semi_axes.setConstant(b.shape.semi_axes.maxCoeff()); });
  out.add_for_bodies([](Body& b) { b.shape.n1 = b.shape.n2 = 2; });
  out.add_for_bodies([](Body& b) { b.shape.semi_axes[1] = b.shape.semi_axes[0], b.shape.n2 = 2; });
  out.add_for_bodies([](Body& b) { b.shape.n2 = b.shape.n1; });
  out.add_for_bodies([](Body& b) { b.shape.n1 = b.shape.n2; });
  for (int i = 0; i < 3; ++i)
    out.add_for_bodies([i](Body& b) { b.shape.semi_axes[i] = b.shape.semi_axes[(i + 1) % 3]; });
  for (const auto whole : {+[](double n) { return std::floor(n); }, +[](double n) { return std::ceil(n); }})
    out.add_for_bodies([whole](Body& b) {
      b.shape.n1 = std::max(2.0, whole(b.shape.n1));
      b.shape.n2 = std::max(2.0, whole(b.shape.n2));
    });
}

/// The line of centres turned to azimuth 0 about body 1's z, and body 2 with it: the same pair where body 1 is of revolution.
void turn_to_azimuth_zero(Described& d) {
  if (!d.place || !d.euler_deg || !(*d.euler_deg)[0].isZero(0)) return;
  (*d.euler_deg)[1][0] -= (*d.place)[1];
  (*d.place)[1] = 0;
}

void add_rotations(List& out) {
  out.add_for_bodies([](Body& b) { b.quaternion = {1, 0, 0, 0}; });
  out.add([](Described& d) { d.pair.body2.quaternion = d.pair.body1.quaternion; });
  for (const double step : {90.0, 45.0, 15.0, 5.0, 1.0}) {
    out.add_for_bodies([step](Body& b) { b.quaternion = with_round_angles(b.quaternion, step); });
    out.add_for_bodies([step](Body& b) { b.quaternion = with_largest_one(with_round_angles(b.quaternion, step)); });
  }
  for (std::size_t i = 0; i < 4; ++i) out.add_for_bodies([i](Body& b) { b.quaternion[i] = 0; });
  out.add_for_bodies([](Body& b) { b.quaternion = with_largest_one(b.quaternion); });
}

void add_angles(List& out) {
  out.add_for_angles([](Vec3<double>& angles) { angles.setZero(); });
  out.add(turn_to_azimuth_zero);
  for (const int i : {2, 0, 1}) out.add_for_angles([i](Vec3<double>& angles) { angles[i] = 0; });
  const auto snap = [](auto angles, double step) {
    for (double& x : angles) x = std::round(x / step) * step;
  };
  for (const double step : {90.0, 45.0, 15.0, 5.0, 1.0}) {
    out.add_for_angles([=](Vec3<double>& angles) { snap(std::span(angles.data(), 3), step); });
    for (int i = 0; i < 3; ++i)
      out.add_for_angles([=](Vec3<double>& angles) { snap(std::span(angles.data() + i, 1), step); });
    out.add_for_place([=](Vec3<double>& place) { snap(std::span(place.data(), 2), step); });
    for (int i = 0; i < 2; ++i)
      out.add_for_place([=](Vec3<double>& place) { snap(std::span(place.data() + i, 1), step); });
  }
}

/// Offsets carry the overlap: zeros in each component, then along the whole line. An overlap ratio is never made 0: bodies that
/// just touch are a special case, not a simple one.
void add_positions(List& out) {
  for (int i = 0; i < 3; ++i) out.add_for_bodies([i](Body& b) { b.position[i] = 0; });
  for (int i = 0; i < 2; ++i) out.add_for_place([i](Vec3<double>& place) { place[i] = 0; });
  for (const double ratio : {0.1, 0.01, 0.001})
    out.add_for_place([ratio](Vec3<double>& place) { place[2] = std::copysign(ratio, place[2]); });
}

/// Each kind of number alone, so that a long overlap does not keep the axes long.
void add_short_decimals(List& out) {
  for (const int digits : {1, 2, 3, 4, 6, 8, 12}) {
    const auto shorten = [digits](auto&& values) {
      for (double& x : values) x = rounded(x, digits);
    };
    out.add_for_bodies([=](Body& b) { shorten(b.shape.semi_axes); });
    for (int i = 0; i < 3; ++i) out.add_for_bodies([=](Body& b) { shorten(std::span(&b.shape.semi_axes[i], 1)); });
    out.add_for_bodies(
        [=](Body& b) { b.shape.n1 = rounded(b.shape.n1, digits), b.shape.n2 = rounded(b.shape.n2, digits); });
    out.add_for_bodies([=](Body& b) { shorten(b.quaternion); });
    out.add_for_bodies([=](Body& b) { shorten(b.position); });
    for (int i = 0; i < 3; ++i) {
      out.add_for_angles([=](Vec3<double>& angles) { angles[i] = rounded(angles[i], digits); });
      out.add_for_place([=](Vec3<double>& place) { place[i] = rounded(place[i], digits); });
    }
  }
}

std::vector<Simplification> all_simplifications() {
  List out;
  add_whole_pair(out);
  add_shapes(out);
  add_rotations(out);
  add_angles(out);
  add_positions(out);
  add_short_decimals(out);
  return out.take();
}

}  // namespace

double rounded(double x, int digits) {
  std::array<char, 40> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific, digits - 1);
  double out = x;
  (void)std::from_chars(text.data(), end, out);
  return out;
}

int cost(const Described& d) {
  int sum = cost(d.pair.body1.shape) + cost_of_rotations(d);
  sum += same(d.pair.body1.shape, d.pair.body2.shape) ? 1 : 8 + cost(d.pair.body2.shape);
  for (const double x : d.pair.body1.position) sum += cost(x);
  for (const double x : d.place ? *d.place : d.pair.body2.position) sum += cost(x);
  return sum;
}

const std::vector<Simplification>& simplifications() {
  static const std::vector<Simplification> all = all_simplifications();
  return all;
}

std::vector<Case> simpler(const Case& c) {
  std::vector<Case> out;
  const Described base{c.pair, {}, {}};
  for (const Simplification& simplify : simplifications()) {
    Described changed = base;
    simplify(changed);
    const auto known = [&](const Case& other) { return same(other.pair, changed.pair); };
    if (!is_valid(changed.pair) || cost(changed) >= cost(base) || std::any_of(out.begin(), out.end(), known)) continue;
    Case simpler = c;
    simpler.pair = changed.pair;
    simpler.expect = {};  // promised for the case as it was
    simpler.provenance["simplified"] = true;
    out.push_back(std::move(simpler));
  }
  return out;
}

}  // namespace plumb
