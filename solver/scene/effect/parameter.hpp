// What the parameter structs of effects share: each tells its fields one by one, so that one reader, one writer and one check of
// ranges serve them all.
//
//   template <class Self, class Visit>
//   static void each_field(Self& self, Visit&& visit) { visit("coefficient", self.coefficient, Range::not_negative); }
//
// The first field is required in a file, the others have the struct's own values. Default-constructed is neutral: the effect is
// there and changes nothing.
#pragma once

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

}  // namespace plumb::scene
