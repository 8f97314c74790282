// An answer measured against the truth: every length over the size of the pair.
#pragma once

#include "reading.hpp"

namespace second_opinion {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

class Measured {
 public:
  Measured(const Claim& claim, Truth& truth);

  /// Of the minima that tie with the lowest, the one nearest to the answer.
  [[nodiscard]] const Minimum& expected() const { return expected_; }
  [[nodiscard]] bool has_points() const { return claim_.answer.point1 && claim_.answer.point2; }
  /// What a place so far from the world's origin carries of rounding, in epsilons.
  [[nodiscard]] double far() const { return far_; }
  /// What a length near the bottom of double's range carries, in epsilons of the size.
  [[nodiscard]] double step() const { return step_; }

  [[nodiscard]] double normal_error() const;   ///< rad; 0 without a normal, as those below without what they are of
  [[nodiscard]] double length_error() const;   ///< of the unit normal
  [[nodiscard]] double overlap_error() const;  ///< above the expected one: > 0
  [[nodiscard]] double points_error() const;
  /// p1 - p2 is overlap times normal: of the answer's own numbers.
  [[nodiscard]] double inconsistency() const;
  [[nodiscard]] double gap_error() const;      ///< |p1 - p2| against |overlap|
  [[nodiscard]] double contact_error() const;  ///< from between the points; of midway from its point
  /// o(n) in the answer's direction over the lowest: of what depth another direction spares.
  [[nodiscard]] double excess() const;

  /// Whether both points are on their surfaces, to within `rounding` epsilons.
  [[nodiscard]] bool is_on_surfaces(double rounding) const;
  [[nodiscard]] double surface_error() const;  ///< to first order
  /// The surface normals at the points are not opposite, or the line between is not along them, whatever rounding of the points does. 0: they may be.
  [[nodiscard]] double turned(double rounding) const;
  /// p1 - p2 is the expected overlap times the expected normal, within that many epsilons.
  [[nodiscard]] bool are_a_pair(double rounding, double allowed) const;

  /// In words, for people: "expected overlap 0.42, got 2.38; normal 131 degrees off".
  [[nodiscard]] std::string figures() const;

 private:
  void choose_expected();
  [[nodiscard]] Vec<Quad> from_first(const Vec<double>& point) const {
    return second_opinion::from_first(claim_.pair, point);
  }
  [[nodiscard]] Vec<Quad> on(int body) const;  ///< the answer's point from its body's centre
  [[nodiscard]] const Body<Quad>& body(int which) const {
    return which == 0 ? truth_.pair().first : truth_.pair().second;
  }

  const Claim& claim_;
  Truth& truth_;
  double size_, step_, far_;
  Minimum expected_;
};

}  // namespace second_opinion
