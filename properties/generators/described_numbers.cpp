// The numbers of a description, one by one.
#include <fmt/format.h>

#include "properties/generators/described.hpp"

namespace plumb {
namespace {

bool same_shapes(const Pair& pair) {
  const auto &a = pair.body1.shape, &b = pair.body2.shape;
  return a.semi_axes == b.semi_axes && a.n1 == b.n1 && a.n2 == b.n2;
}

/// The shapes that a number belongs to: one body's, or both where they are equal.
struct Owners {
  bool first, second;
  std::string field, words;

  template <class Change>
  void each(Described& d, Change change) const {
    if (first) change(d.pair.body1.shape);
    if (second) change(d.pair.body2.shape);
  }
};

const char* axes_word(const Superellipsoid<double>& shape, const std::vector<int>& equal) {
  if (equal.size() == 3) return shape.n1 == 2 && shape.n2 == 2 ? "radius" : "semi-axes";
  if (equal.size() == 2) {
    const int sum = equal[0] + equal[1];
    return sum == 1 ? "semi-axes a and b" : (sum == 2 ? "semi-axes a and c" : "semi-axes b and c");
  }
  constexpr std::array<const char*, 3> words{"semi-axis a", "semi-axis b", "semi-axis c"};
  return words[static_cast<std::size_t>(equal[0])];
}

std::string indices(const std::vector<int>& of) {
  std::string out;
  for (const int i : of) out += (out.empty() ? "" : ",") + std::to_string(i);
  return out;
}

void add_axes(std::vector<Number>& out, const Superellipsoid<double>& shape, const Owners& owners) {
  for (int i = 0; i < 3; ++i) {
    std::vector<int> equal;
    for (int j = 0; j < 3; ++j)
      if (shape.semi_axes[j] == shape.semi_axes[i]) equal.push_back(j);
    if (equal.front() != i) continue;
    out.push_back({fmt::format("{}.shape.superellipsoid.semi_axes[{}]", owners.field, indices(equal)),
                   fmt::format("{} of {}", axes_word(shape, equal), owners.words), Quantity::length, shape.semi_axes[i],
                   [owners, equal](Described& d, double x) {
                     owners.each(d, [&](Superellipsoid<double>& s) {
                       for (const int j : equal) s.semi_axes[j] = x;
                     });
                   }});
  }
}

void add_exponents(std::vector<Number>& out, const Superellipsoid<double>& shape, const Owners& owners) {
  if (shape.n1 == 2 && shape.n2 == 2) return;
  const auto add = [&](const char* which, const char* word, double value, bool sets1, bool sets2) {
    out.push_back({fmt::format("{}.shape.superellipsoid.exponents[{}]", owners.field, which),
                   fmt::format("{} of {}", word, owners.words), Quantity::exponent, value, [=](Described& d, double x) {
                     owners.each(d, [&](Superellipsoid<double>& s) {
                       if (sets1) s.n1 = x;
                       if (sets2) s.n2 = x;
                     });
                   }});
  };
  if (shape.n1 == shape.n2) return add("0,1", "exponents", shape.n1, true, true);
  add("0", "exponent n1", shape.n1, true, false);
  add("1", "exponent n2", shape.n2, false, true);
}

void add_shapes(std::vector<Number>& out, const Pair& pair) {
  const bool same = same_shapes(pair);
  for (const bool second : {false, true}) {
    if (second && same) break;
    const Owners owners{!second || same, second || same, same ? "bodies[0,1]" : (second ? "bodies[1]" : "bodies[0]"),
                        same ? "both bodies" : (second ? "body 2" : "body 1")};
    const auto& shape = second ? pair.body2.shape : pair.body1.shape;
    add_axes(out, shape, owners);
    add_exponents(out, shape, owners);
  }
}

Body& body_of(Described& d, std::size_t i) {
  return i == 0 ? d.pair.body1 : d.pair.body2;
}

void add_angles(std::vector<Number>& out, const Vec3<double>& angles, std::size_t body) {
  constexpr std::array<const char*, 3> words{"phi", "tilt (theta)", "psi"};
  if (body == 0 && angles.isZero(0)) return;
  for (int k = 0; k < 3; ++k)
    out.push_back({fmt::format("bodies[{}].orientation.euler_zxz_deg[{}]", body, k),
                   fmt::format("{} of body {}", words[static_cast<std::size_t>(k)], body + 1),
                   k == 1 ? Quantity::zenith : Quantity::angle, angles[k],
                   [body, k](Described& d, double x) { (*d.euler_deg)[body][k] = x; }});
}

void add_quaternion(std::vector<Number>& out, const Described& described, std::size_t body) {
  const auto& q = (body == 0 ? described.pair.body1 : described.pair.body2).quaternion;
  if (q == std::array<double, 4>{1, 0, 0, 0}) return;
  for (std::size_t k = 0; k < 4; ++k)
    out.push_back({fmt::format("bodies[{}].orientation.quaternion_wxyz[{}]", body, k),
                   fmt::format("quaternion's {} of body {}", "wxyz"[k], body + 1), Quantity::other, q[k],
                   [body, k](Described& d, double x) { body_of(d, body).quaternion[k] = x; }});
}

void add_position(std::vector<Number>& out, const Described& described, std::size_t body) {
  const Vec3<double>& position = (body == 0 ? described.pair.body1 : described.pair.body2).position;
  if (body == 0 && position.isZero(0)) return;
  for (int k = 0; k < 3; ++k)
    out.push_back({fmt::format("bodies[{}].position[{}]", body, k), fmt::format("{} of body {}", "xyz"[k], body + 1),
                   Quantity::other, position[k],
                   [body, k](Described& d, double x) { body_of(d, body).position[k] = x; }});
}

void add_place(std::vector<Number>& out, const Vec3<double>& place) {
  constexpr std::array<const char*, 3> fields{"placement.line_deg[0]", "placement.line_deg[1]",
                                              "placement.overlap_ratio"};
  constexpr std::array<const char*, 3> words{"zenith of the centre line", "azimuth of the centre line",
                                             "overlap ratio"};
  constexpr std::array quantities{Quantity::zenith, Quantity::angle, Quantity::ratio};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = static_cast<int>(k);
    out.push_back(
        {fields[k], words[k], quantities[k], place[at], [at](Described& d, double x) { (*d.place)[at] = x; }});
  }
}

}  // namespace

std::vector<Number> numbers_of(const Described& described) {
  std::vector<Number> out;
  add_shapes(out, described.pair);
  for (const std::size_t body : {0u, 1u}) {
    if (described.euler_deg)
      add_angles(out, (*described.euler_deg)[body], body);
    else
      add_quaternion(out, described, body);
  }
  add_position(out, described, 0);
  if (described.place)
    add_place(out, *described.place);
  else
    add_position(out, described, 1);
  return out;
}

}  // namespace plumb
