// What a solver answers: which pairs, which fields. What it does not claim it is not asked, and it is not judged by it.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "corpus/json/fields.hpp"
#include "solver/contact.hpp"

namespace plumb {

enum class Shapes { superellipsoids, ellipsoids, spheres };
/// Of bodies apart.
enum class Apart { distance, verdict, none };
/// midway: one between the bodies, in Contact::contact_point.
enum class Points { two, midway, none };

/// The words of files and tables: "ellipsoids", "verdict", "midway", ..
[[nodiscard]] std::string_view name(Shapes shapes);
[[nodiscard]] std::string_view name(Apart apart);
[[nodiscard]] std::string_view name(Points points);

/// By default those of a solver that answers everything.
struct Abilities {
  std::string name = {}, version = {}, licence = {};  ///< empty: not said
  Shapes shapes = Shapes::superellipsoids;
  std::array<double, 2> exponents{1, std::numeric_limits<double>::infinity()};  ///< of superellipsoids: least, greatest
  Apart apart = Apart::distance;
  Points points = Points::two;
  bool normal = true;
  bool warm = false;  ///< it can start from the last answer
  Problem problem = Problem::common_normal;
  double tolerance = 0;  ///< its own, relative to the larger body's size; 0: as far as rounding lets it

  /// Whether both shapes are among those that it takes.
  [[nodiscard]] bool takes(const Pair& pair) const;
  /// Whether it claims an answer to a pair of that certified verdict.
  [[nodiscard]] bool claims(const Pair& pair, Verdict certified) const;
  /// An answer without what is not claimed: fields become NaN. Where of bodies apart the verdict is all that is claimed, saying so
  /// is an answer, whatever its status.
  [[nodiscard]] Contact<double> claimed(Contact<double> answer) const;
  /// Whether the answer has every number that is claimed of such a pair.
  [[nodiscard]] bool is_whole(const Contact<double>& answer) const;
};

/// { "name", "version", "licence", "shapes", "exponents", "apart", "points", "normal", "problem", "tolerance", "warm" }, without
/// what was not said.
[[nodiscard]] Json abilities_json(const Abilities& abilities);
/// The same fields, each optional. Throws FieldError.
[[nodiscard]] Abilities read_abilities(const Field& from);

/// Empty, or why a word cannot be a solver's name: it stands in file names and commands.
[[nodiscard]] std::string refuse_solver_name(std::string_view word);

}  // namespace plumb
