// A frozen hard case's certificate, and what an answer in any arithmetic is off by it: by the rule that
// corpus/cases/hard/README.md states for everybody, with none of plumb's laws and no reference at hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {

/// One common normal of the certificate: the answer, one that ties with it, or one that is close.
struct CertifiedAnswer {
  Bounds overlap;
  Vec3<Real50> normal, point1, point2;
  double normal_radius = 0, points_radius = 0;  ///< of the proof
  Condition condition;
  double nearby_normal = 0, nearby_points = 0;  ///< how far the answers to inputs within 8 epsilon of double's are
};

/// Where a condition number bounds nothing: balls that hold the answers to every input within 8 epsilon of double's.
struct SolutionBalls {
  Vec3<Real50> normal, point1, point2;
  double normal_radius = std::numeric_limits<double>::infinity();
  double points_radius = std::numeric_limits<double>::infinity();
};

struct CertifiedCase {
  Case c;
  Bounds overlap;
  Condition condition;
  std::vector<CertifiedAnswer> answers;  ///< those that are located; may be empty
  std::optional<SolutionBalls> balls;
  std::string ladder, knob;
  double value = 0;
  std::uint64_t step = 0;  ///< from 1
};

/// Throws InputFailure where the case has no certificate of a ladder's case.
[[nodiscard]] CertifiedCase read_certified(Case c, const std::string& file, int line);

/// Overlap and points relative to the size, or to the overlap where that is longer; normal in rad.
struct Errors3 {
  double overlap = 0, normal = 0, points = 0;
};

struct CertifiedErrors {
  Errors3 error;       ///< against the nearest answer that ties within rounding; NaN where there is none
  Errors3 allowed;     ///< infinite where nothing is certified
  std::string broken;  ///< what the answer contradicts in itself; empty: nothing
  [[nodiscard]] bool is_right() const;
};

/// `epsilon`: of the arithmetic.
[[nodiscard]] CertifiedErrors errors_against(const CertifiedCase& truth, const Contact<Real50>& answer, double epsilon);

}  // namespace plumb::reports
