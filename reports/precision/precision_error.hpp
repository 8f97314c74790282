// How far an answer is from the certified reference: the vertical axis of plumb report-precision.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "corpus/case/case.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {

/// What an answer of one problem is held against, in 50 digits.
struct Truth {
  bool known = false;  ///< one answer, proved
  Real50 overlap;      ///< length
  Vec3<Real50> normal, point1, point2;
  Condition condition;
  double size = 1;  ///< length
};
[[nodiscard]] Truth truth_of(const Pair& pair, Problem problem);

/// The fields that are judged, exactly.
template <class S>
[[nodiscard]] Contact<Real50> widened(const Contact<S>& from) {
  const auto wide = [](const Vec3<S>& v) -> Vec3<Real50> { return {Real50(v[0]), Real50(v[1]), Real50(v[2])}; };
  Contact<Real50> out;
  out.status = from.status;
  out.verdict = from.verdict;
  out.iterations = from.iterations;
  out.overlap = Real50(from.overlap);
  out.normal = wide(from.normal);
  out.point1 = wide(from.point1);
  out.point2 = wide(from.point2);
  return out;
}

/// NaN where the truth is not known, infinite where a field of the answer is not finite.
struct AnswerError {
  double overlap, points;  ///< relative to the size
  double normal;           ///< rad
};
[[nodiscard]] AnswerError error_of(const Contact<Real50>& answer, const Truth& truth);

/// Over the pairs of a set, NaN left out.
struct Spread {
  double median, p99, most;
};
[[nodiscard]] Spread spread(std::vector<double> values);

/// What the pairs' condition numbers allow in a scalar: times its epsilon, as an AnswerError is.
struct Envelope {
  std::string_view scalar;
  Spread overlap, normal, points;
};
[[nodiscard]] Envelope envelope(const std::vector<Truth>& truths, std::string_view scalar, double epsilon);
[[nodiscard]] std::vector<Envelope> envelopes(const std::vector<Truth>& truths);

}  // namespace plumb::reports
