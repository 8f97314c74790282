// Pairs whose lens has not two caps, or is as flat as can be: what random families hardly draw.
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "solver/contact.hpp"

namespace plumb {

struct SpecialPair {
  std::string_view name;
  Pair pair;
};

[[nodiscard]] inline Body special_body(const Vec3<double>& semi_axes, double exponent, const Vec3<double>& position,
                                       double turned_about_y = 0) {
  return {
      {semi_axes, exponent, exponent}, position, {std::cos(turned_about_y / 2), 0, std::sin(turned_about_y / 2), 0}};
}

[[nodiscard]] inline std::vector<SpecialPair> special_pairs() {
  const Body die = special_body({1, 1, 1}, 8, {0, 0, 0}), plate = special_body({2, 2, 0.1}, 4, {0, 0, 0}),
             disc = special_body({2, 2, 0.1}, 2, {0, 0, 0});
  return {{"rod through a plate", {plate, special_body({0.1, 0.1, 2}, 4, {0.3, 0.2, 0.1}, 0.3)}},
          {"needle through a disc", {disc, special_body({0.1, 0.15, 2}, 2, {0.3, 0.2, 0.1}, 0.3)}},
          {"tip through a disc", {disc, special_body({0.5, 0.6, 2}, 2, {0.1, 0.2, 1.87})}},
          {"blunt tip through a plate", {plate, special_body({0.5, 0.6, 2}, 2.5, {0.1, 0.2, 1.87})}},
          {"crossed rods",
           {special_body({0.3, 0.3, 2}, 4, {0, 0, 0}, 1.5707963), special_body({0.25, 0.3, 2}, 4, {0.1, 0, 0})}},
          {"inside", {die, special_body({0.2, 0.3, 0.1}, 4, {0.1, 0.2, 0.3}, 0.3)}},
          {"die on die", {die, special_body({1, 1, 1}, 8, {0, 0, 1.99})}},
          {"die on die, aside", {die, special_body({1, 1, 1}, 8, {0.7, 0.4, 1.99})}},
          {"small die on die", {die, special_body({0.1, 0.1, 0.1}, 8, {0.3, 0.2, 1.09})}},
          {"edge on face", {die, special_body({1, 1, 1}, 8, {0.1, 0.2, 2.29}, 0.7853981)}}};
}

/// A pair for each exponent and tilt about y, rad, of body 2.
struct PatchLadder {
  std::string_view name;
  Pair (*pair)(double exponent, double tilt);
};

inline constexpr std::array patch_exponents{2.0, 3.0, 4.0, 8.0, 20.0, 50.0};

namespace patch_ladder {

/// A tilt of 1e-16 is lost in the angle of a cosine: (1, tilt/2) keeps it.
[[nodiscard]] inline Pair on_a_die(const Vec3<double>& semi_axes, double exponent, const Vec3<double>& position,
                                   double tilt) {
  Pair out{special_body({1, 1, 1}, exponent, {0, 0, 0}), special_body(semi_axes, exponent, position)};
  out.body2.quaternion = {1, 0, std::tan(tilt / 2), 0};
  return out;
}
[[nodiscard]] inline Pair face_on_face(double exponent, double tilt) {
  return on_a_die({1, 1, 1}, exponent, {0, 0, 1.99}, tilt);
}
/// How high the die's surface is above a point of its plane of symmetry.
[[nodiscard]] inline double height_of_die(double exponent, double x, double y) {
  return std::pow(1 - std::pow(x, exponent) - std::pow(y, exponent), 1 / exponent);
}
/// Dice that share a quarter of a face.
[[nodiscard]] inline Pair offset_faces(double exponent, double tilt) {
  const double aside = 0.9 * std::pow(2.0, -1 / exponent);  // 0.9 of the way to the middle between edges
  const double apart = 2 * height_of_die(exponent, aside / 2, aside / 2) - 0.05;
  return on_a_die({1, 1, 1}, exponent, {aside, aside, apart}, tilt);
}
[[nodiscard]] inline Pair small_face(double exponent, double tilt) {
  const double radius = 0.1;
  const double apart = height_of_die(exponent, 0.3, 0.2) + 0.9 * radius;
  return on_a_die({radius, radius, radius}, exponent, {0.3, 0.2, apart}, tilt);
}
/// Body 1 on its edge along y: its axes x and z turned by 45 degrees.
[[nodiscard]] inline Pair edge_on_face(double exponent, double tilt) {
  const double edge = std::sqrt(2.0) * std::pow(0.5, 1 / exponent);  // from the centre
  Pair out = on_a_die({1, 1, 1}, exponent, {0.1, 0.2, edge + 0.97}, tilt);
  out.body1.quaternion = {std::cos(std::atan(1.0) / 2), 0, std::sin(std::atan(1.0) / 2), 0};
  return out;
}

}  // namespace patch_ladder

inline constexpr std::array patch_ladders{
    PatchLadder{"face_on_face", patch_ladder::face_on_face}, PatchLadder{"offset_faces", patch_ladder::offset_faces},
    PatchLadder{"small_face", patch_ladder::small_face}, PatchLadder{"edge_on_face", patch_ladder::edge_on_face}};

}  // namespace plumb
