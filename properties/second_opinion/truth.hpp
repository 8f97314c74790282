// The answer to a pair by this program's own computation, and how far it moves when the input does by a rounding.
#pragma once

#include <optional>
#include <string>

#include "refine.hpp"

namespace second_opinion {

enum class Problem { common_normal, deepest_points, midway };

/// How far an answer moves within rounding of its input: rad, and lengths over the size.
struct Sensitivity {
  double normal = 0, overlap = 0, points = 0;
};

/// Lengths over the size, places from body 1's centre.
class Truth {
 public:
  Truth(const GivenPair& given, Problem problem);

  [[nodiscard]] const Pair<Quad>& pair() const { return pair_; }
  /// The lowest first; those after it are other minima that are nearly as low. Never empty where `doubt` is.
  [[nodiscard]] const std::vector<Minimum>& lowest() const { return lowest_; }
  /// Why nothing can be said; empty: something can.
  [[nodiscard]] const std::string& doubt() const { return doubt_; }
  /// No direction is lower than this.
  [[nodiscard]] double proven() const { return proven_; }
  /// Measured when first asked for: it costs several solutions.
  [[nodiscard]] const Sensitivity& sensitivity();
  /// A minimum found from elsewhere joins the others, where it is another.
  void look_from(const Vec<Quad>& normal);

 private:
  void find_common_normal();
  void find_single();

  GivenPair given_;
  Problem problem_;
  Pair<Quad> pair_;
  std::vector<Minimum> lowest_;
  std::string doubt_;
  double proven_ = 0;
  std::optional<Sensitivity> sensitivity_;
};

/// The two problems of the geometric potential: the one solution, from a direction near its normal or, without, from a search. nullopt where
/// this program does not find it, or not one alone.
[[nodiscard]] std::optional<Minimum> deepest_points(const Pair<Quad>& pair);
[[nodiscard]] std::optional<Minimum> midway(const Pair<Quad>& pair);
/// Where the force acts of midway: the point of equal potentials.
[[nodiscard]] std::optional<Vec<Quad>> midway_point(const Pair<Quad>& pair);

}  // namespace second_opinion
