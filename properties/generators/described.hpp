// A pair in the numbers that decide how hard it is, as a case file may spell them: Euler angles in degrees, and body 2 on a
// line from body 1 at an overlap ratio. Those can be changed one at a time; coordinates cannot.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"

namespace plumb {

struct Described {
  Pair pair;                                             ///< what the other fields do not say: the shapes always
  std::optional<std::array<Vec3<double>, 2>> euler_deg;  ///< of both bodies, X-convention; else the pair's quaternions
  std::optional<Vec3<double>>
      place;  ///< zenith and azimuth (degrees) and overlap ratio; else the pair's position of body 2
};

/// With body 1 at the origin, in angles and with a place: the same pair up to rounding. Without a place where first touch is
/// not solved.
[[nodiscard]] Described describe(const Pair& pair);
/// The same pair, up to rounding, in the axes of body 1.
[[nodiscard]] Pair in_axes_of_body1(const Pair& pair);

/// The fields "bodies" and, where there is a place, "placement" of a case file.
[[nodiscard]] Json described_json(const Described& described);

/// The pair that those fields are read as, bit for bit: by the reader of case files. nullopt where it refuses them.
[[nodiscard]] std::optional<Pair> pair_of(const Described& described);

enum class Quantity { length, exponent, angle, zenith, ratio, other };

/// One number of a description. One that stands in several places (the radius of a spheroid, the shape of two equal bodies)
/// is one number.
struct Number {
  std::string field;  ///< as the file has it: "bodies[1].shape.superellipsoid.semi_axes[0,1]"
  std::string words;  ///< "radius of body 2"
  Quantity quantity = Quantity::other;
  double value = 0;
  std::function<void(Described&, double)> set;
};

/// Those that the description spells: no exponents of an ellipsoid, no rotation and position of a body that has none.
[[nodiscard]] std::vector<Number> numbers_of(const Described& described);

/// Whether a pair lies where plumb declares to answer: legal, aspects up to 1000, exponents 1.1 to 50.
[[nodiscard]] bool in_domain(const Pair& pair);

/// A way to make a description simpler; one that does not apply leaves it as it is.
using Simplification = std::function<void(Described&)>;

/// All of them, in order of preference: equal bodies, spheres before spheroids before triaxial, whole exponents, round angles,
/// short decimals.
[[nodiscard]] const std::vector<Simplification>& simplifications();

/// To so many decimal digits.
[[nodiscard]] double rounded(double x, int digits);

/// Falls with each simplification that is one: a whole number, so that shrinking ends.
[[nodiscard]] int cost(const Described& described);

}  // namespace plumb
