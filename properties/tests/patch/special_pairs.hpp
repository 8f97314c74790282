// Pairs whose lens has not two caps, or is as flat as can be: what random families hardly draw.
#pragma once

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
          {"crossed rods",
           {special_body({0.3, 0.3, 2}, 4, {0, 0, 0}, 1.5707963), special_body({0.25, 0.3, 2}, 4, {0.1, 0, 0})}},
          {"inside", {die, special_body({0.2, 0.3, 0.1}, 4, {0.1, 0.2, 0.3}, 0.3)}},
          {"die on die", {die, special_body({1, 1, 1}, 8, {0, 0, 1.99})}},
          {"die on die, aside", {die, special_body({1, 1, 1}, 8, {0.7, 0.4, 1.99})}},
          {"small die on die", {die, special_body({0.1, 0.1, 0.1}, 8, {0.3, 0.2, 1.09})}},
          {"edge on face", {die, special_body({1, 1, 1}, 8, {0.1, 0.2, 2.29}, 0.7853981)}}};
}

}  // namespace plumb
