// Simpler cases: every candidate keeps the pair legal and lowers `cost`, a whole number, so that shrinking ends.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "properties/families.hpp"
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
  return equal(a.body1, b.body1) && equal(a.body2, b.body2);
}

int cost(const Pair& pair) {
  int sum = cost(pair.body1.shape);
  sum += same(pair.body1.shape, pair.body2.shape) ? 1 : 8 + cost(pair.body2.shape);
  for (const Body* body : {&pair.body1, &pair.body2}) {
    for (const double x : body->position) sum += cost(x);
    const auto& q = body->quaternion;
    const bool repeated = body == &pair.body2 && q == pair.body1.quaternion;
    for (const double x : q) sum += repeated ? 0 : cost(x);
  }
  return sum;
}

double rounded(double x, int digits) {
  std::array<char, 40> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific, digits - 1);
  double out = x;
  (void)std::from_chars(text.data(), end, out);
  return out;
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

/// The candidates of one case, collected in order of preference.
class Candidates {
 public:
  explicit Candidates(const Case& base) : base_(base), cost_(cost(base.pair)) {}

  template <class Change>
  void add(Change change) {
    Pair pair = base_.pair;
    change(pair);
    const auto known = [&](const Case& c) { return same(c.pair, pair); };
    if (!is_valid(pair) || cost(pair) >= cost_ || std::any_of(out_.begin(), out_.end(), known)) return;
    Case simpler = base_;
    simpler.pair = pair;
    simpler.expect = {};  // promised for the case as it was
    simpler.provenance["simplified"] = true;
    out_.push_back(std::move(simpler));
  }

  /// The same change on both bodies at once, then on each alone.
  template <class Change>
  void add_for_bodies(Change change) {
    add([&](Pair& p) { change(p.body1), change(p.body2); });
    add([&](Pair& p) { change(p.body1); });
    add([&](Pair& p) { change(p.body2); });
  }

  [[nodiscard]] std::vector<Case> take() { return std::move(out_); }

 private:
  const Case& base_;
  int cost_;
  std::vector<Case> out_;
};

void add_whole_pair(Candidates& out) {
  out.add([](Pair& p) { p.body2.shape = p.body1.shape; });
  out.add([](Pair& p) { p.body1.shape = p.body2.shape; });
  out.add([](Pair& p) {
    p.body2.position -= p.body1.position;
    p.body1.position.setZero();
  });
  out.add([](Pair& p) {  // the unit of length
    const double size = size_of(p);
    for (Body* body : {&p.body1, &p.body2}) {
      body->shape.semi_axes /= size;
      body->position /= size;
    }
  });
}

void add_shapes(Candidates& out) {
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

void add_rotations(Candidates& out) {
  out.add_for_bodies([](Body& b) { b.quaternion = {1, 0, 0, 0}; });
  out.add([](Pair& p) { p.body2.quaternion = p.body1.quaternion; });
  for (const double step : {90.0, 45.0, 15.0, 5.0, 1.0}) {
    out.add_for_bodies([step](Body& b) { b.quaternion = with_round_angles(b.quaternion, step); });
    out.add_for_bodies([step](Body& b) { b.quaternion = with_largest_one(with_round_angles(b.quaternion, step)); });
  }
  for (std::size_t i = 0; i < 4; ++i) out.add_for_bodies([i](Body& b) { b.quaternion[i] = 0; });
  out.add_for_bodies([](Body& b) { b.quaternion = with_largest_one(b.quaternion); });
}

/// Offsets carry the overlap: zeros in each component, then along the whole line.
void add_positions(Candidates& out) {
  for (int i = 0; i < 3; ++i) out.add_for_bodies([i](Body& b) { b.position[i] = 0; });
}

/// Each kind of number alone, so that a long overlap does not keep the axes long.
void add_short_decimals(Candidates& out) {
  for (const int digits : {1, 2, 3, 4, 6, 8, 12}) {
    const auto shorten = [digits](auto&& values) {
      for (double& x : values) x = rounded(x, digits);
    };
    out.add_for_bodies([&](Body& b) { shorten(b.shape.semi_axes); });
    out.add_for_bodies(
        [&](Body& b) { b.shape.n1 = rounded(b.shape.n1, digits), b.shape.n2 = rounded(b.shape.n2, digits); });
    out.add_for_bodies([&](Body& b) { shorten(b.quaternion); });
    out.add_for_bodies([&](Body& b) { shorten(b.position); });
  }
}

}  // namespace

std::vector<Case> simpler(const Case& c) {
  Candidates out(c);
  add_whole_pair(out);
  add_shapes(out);
  add_rotations(out);
  add_positions(out);
  add_short_decimals(out);
  return out.take();
}

}  // namespace plumb
