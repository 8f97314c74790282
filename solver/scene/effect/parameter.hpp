// What the parameter structs of effects share: each tells its fields one by one, so that one reader, one writer and one check of
// ranges serve them all.
//
//   template <class Self, class Visit>
//   static void each_field(Self& self, Visit&& visit) { visit("coefficient", self.coefficient, Range::not_negative); }
//
// The first field is required in a file, the others have the struct's own values. Default-constructed is neutral: the effect is
// there and changes nothing.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb::scene {

// What role() and install() of each effect take and give: effect.hpp, world.hpp.
struct Scene;
struct Role;
struct World;

/// Of a number; each component of a vector is any finite number.
enum class Range {
  any,
  not_negative,
  positive,
  fraction,        ///< 0..1
  restitution,     ///< above 0, up to 1
  poissons_ratio,  ///< above -1, up to 1/2
  one_to_two,
};

/// What an error says of a number that is not.
[[nodiscard]] inline const char* words(Range range) {
  switch (range) {
    case Range::any: break;
    case Range::not_negative: return "must be a number, 0 or more";
    case Range::positive: return "must be a positive number";
    case Range::fraction: return "must be a number from 0 to 1";
    case Range::restitution: return "must be a number above 0, at most 1";
    case Range::poissons_ratio: return "must be a number above -1, at most 0.5";
    case Range::one_to_two: return "must be a number from 1 to 2";
  }
  return "must be a finite number";
}

/// Whether x is in it; a NaN is in none but `any`.
[[nodiscard]] inline bool is_within(Range range, double x) {
  switch (range) {
    case Range::any: return true;
    case Range::not_negative: return x >= 0;
    case Range::positive: return x > 0;
    case Range::fraction: return x >= 0 && x <= 1;
    case Range::restitution: return x > 0 && x <= 1;
    case Range::poissons_ratio: return x > -1 && x <= 0.5;
    case Range::one_to_two: return x >= 1 && x <= 2;
  }
  return false;
}

/// Of effects that two materials may have together: what each has of its own, and one of both.
template <class Parameters>
concept Mixes = requires(const Parameters& one) {
  { Parameters::mixed(one, one) } -> std::same_as<Parameters>;
};
/// Of those, the elastic laws: what a rigid material has.
template <class Parameters>
concept IsElastic = Mixes<Parameters> && requires {
  { Parameters::rigid() } -> std::same_as<Parameters>;
};

/// Each field, all numbers, the geometric mean of both; alike ones to the bit.
template <class Parameters>
[[nodiscard]] Parameters geometric_mean(const Parameters& first, const Parameters& second) {
  constexpr std::size_t most_fields = 5;
  std::array<double, most_fields> others{};
  std::size_t count = 0;
  Parameters::each_field(second, [&](std::string_view, double value, Range) { others.at(count++) = value; });
  Parameters out = first;
  count = 0;
  Parameters::each_field(out, [&](std::string_view, double& value, Range) {
    const double other = others.at(count++);
    if (value != other) value = std::sqrt(value) * std::sqrt(other);
  });
  return out;
}

}  // namespace plumb::scene
