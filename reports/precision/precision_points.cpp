#include "reports/precision/precision_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>

#include "corpus/command/interrupt.hpp"
#include "reports/bench/quantile.hpp"

namespace plumb::reports {
namespace {

/// Huge bodies have no points in float.
bool is_answer(const Contact<Real50>& given) {
  return given.status == Status::converged && isfinite(given.overlap) && given.normal.allFinite();
}

/// Of one variant, by the pair.
struct Tally {
  std::vector<double> overlap, normal, points;  ///< of judged answers
  std::vector<double> ns, iterations;
  std::size_t failed = 0;

  void append(const Contact<Real50>& answer, const Truth& truth) {
    iterations.push_back(answer.iterations);
    failed += is_answer(answer) ? 0 : 1;
    if (!is_answer(answer) || !truth.known) return;
    const AnswerError error = error_of(answer, truth);
    overlap.push_back(error.overlap);
    normal.push_back(error.normal);
    points.push_back(error.points);
  }
};

Tally tally_of(const Variant& variant, const std::vector<Case>& cases, const Truths& truths) {
  using Clock = std::chrono::steady_clock;
  const std::size_t count = variant.timed ? cases.size() : std::min(cases.size(), pairs_in_fifty_digits);
  Tally out;
  for (std::size_t i = 0; i < count && !interrupted(); ++i) {
    const auto start = Clock::now();
    const Contact<Real50> answer = variant.judged(cases[i].pair);
    out.ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    out.append(answer, truths.at(variant.problem)[i]);
  }
  return out;
}

Measurement timed_once(const Variant& variant, const Tally& tally) {
  Measurement out;
  out.method = variant.method;
  out.solves = tally.ns.size();
  out.median_ns = quantile(tally.ns, 0.5);
  out.p99_ns = quantile(tally.ns, 0.99);
  out.median_iterations = quantile(tally.iterations, 0.5);
  out.most_iterations = quantile(tally.iterations, 1);
  return out;
}

/// But for the time, where there is one in turns with others.
Point judged(const Variant& variant, const std::vector<Case>& cases, const Truths& truths) {
  constexpr double far = 0.01 * std::numbers::pi / 180;
  const Tally tally = tally_of(variant, cases, truths);
  Point out{variant, timed_once(variant, tally), spread(tally.overlap), spread(tally.normal), spread(tally.points)};
  out.judged = tally.normal.size();
  out.failed = static_cast<double>(tally.failed) / static_cast<double>(tally.ns.size());
  const auto off = std::count_if(tally.normal.begin(), tally.normal.end(), [](double error) { return error > far; });
  out.off = out.judged > 0 ? static_cast<double>(off) / static_cast<double>(out.judged)
                           : std::numeric_limits<double>::quiet_NaN();
  return out;
}

/// What a user can count on: the normal's p99, and nothing at all where more than one answer in a hundred is not there.
double counted_error(const Point& point) {
  const bool is_there = point.failed <= 0.01 && !std::isnan(point.normal.p99);
  return is_there ? point.normal.p99 : std::numeric_limits<double>::infinity();
}

/// Answers of one problem; certificates are an axis of their own.
bool is_candidate(const Point& p) {
  return p.variant.problem == Problem::common_normal && p.variant.certificate.empty() &&
         std::isfinite(counted_error(p));
}

void mark_front(std::vector<Point>& points) {
  for (Point& p : points) {
    const auto beats = [&](const Point& q) {
      const bool no_worse = q.time.median_ns <= p.time.median_ns && counted_error(q) <= counted_error(p);
      const bool better = q.time.median_ns < p.time.median_ns || counted_error(q) < counted_error(p);
      return is_candidate(q) && no_worse && better;
    };
    p.is_on_front = is_candidate(p) && std::none_of(points.begin(), points.end(), beats);
  }
}

std::vector<Job> jobs_of(const std::vector<Variant>& all, const std::vector<Case>& cases) {
  std::vector<Job> jobs;
  for (const Variant& variant : all) {
    if (!variant.timed) continue;
    Job job;
    job.solver.name = variant.method;
    job.solver.solve = [timed = variant.timed](const Pair& pair, const Want&, const Contact<double>*) {
      return timed(pair);
    };
    for (const Case& c : cases) job.tasks.push_back({c.pair, {}});
    jobs.push_back(std::move(job));
  }
  return jobs;
}

/// The quickest to a p99 of the normal; nullptr where none gets there. `method` empty: of any.
const Point* quickest(const std::vector<Point>& points, double error, std::string_view method) {
  const Point* best = nullptr;
  for (const Point& p : points) {
    const bool reaches = is_candidate(p) && counted_error(p) <= error;
    if (!reaches || (!method.empty() && p.variant.method != method)) continue;
    if (best == nullptr || p.time.median_ns < best->time.median_ns) best = &p;
  }
  return best;
}

std::string in_words(const Point& p) {
  return fmt::format("{} at {} in {:.3g} us (p99 {:.0e})", name_of(p.variant), tolerance_text(p.variant.tolerance),
                     p.time.median_ns * 1e-3, p.normal.p99);
}

/// Requested accuracies by what is quickest to them.
struct Standing {
  std::vector<std::string> by_auto, by_others, by_none;
};

Standing standing_of(const std::vector<Point>& points) {
  Standing out;
  for (const double accuracy : std::span(tolerances).first(tolerances.size() - 1)) {
    const std::string text = fmt::format("{:.0e}", accuracy);
    const Point *best = quickest(points, accuracy, ""), *ours = quickest(points, accuracy, "auto");
    if (best == nullptr)
      out.by_none.push_back(text);
    else if (best == ours)
      out.by_auto.push_back(text);
    else
      out.by_others.push_back(fmt::format("{}: {}, auto {}", text, in_words(*best),
                                          ours == nullptr ? "does not get there" : in_words(*ours)));
  }
  return out;
}

}  // namespace

Truths truths_of(const std::vector<Case>& cases) {
  Truths out;
  for (const Problem problem : problems)
    for (const Case& c : cases)
      if (!interrupted()) out[problem].push_back(truth_of(c.pair, problem));
  return out;
}

std::vector<Point> points_of(const std::vector<Variant>& all, const std::vector<Case>& cases, const Truths& truths,
                             int repeats) {
  std::vector<Point> points;
  for (const Variant& variant : all)
    if (!interrupted()) points.push_back(judged(variant, cases, truths));
  const std::vector<Measurement> times = measure(jobs_of(all, cases), repeats);
  if (interrupted()) return {};
  auto time = times.begin();
  for (Point& point : points)
    if (point.variant.timed) point.time = *time++;
  mark_front(points);
  return points;
}

Front front_of(const std::vector<Point>& points) {
  const auto is_of_auto = [](const Point& p) { return p.variant.method == "auto"; };
  if (std::none_of(points.begin(), points.end(), is_of_auto)) return {false, "auto was not asked for"};
  const Standing at = standing_of(points);
  std::string note = "auto is the quickest to a normal's p99 of " +
                     (at.by_auto.empty() ? "none" : fmt::format("{}", fmt::join(at.by_auto, ", ")));
  if (!at.by_others.empty()) note += fmt::format(". Quicker to {}", fmt::join(at.by_others, "; "));
  if (!at.by_none.empty()) note += fmt::format(". None answers 99 in 100 within {}", fmt::join(at.by_none, ", "));
  std::vector<std::string> others;
  for (const Point& p : points)
    if (p.is_on_front && !is_of_auto(p)) others.push_back(in_words(p));
  if (!others.empty()) note += fmt::format(". Also on the front: {}", fmt::join(others, "; "));
  return {at.by_others.empty() && !at.by_auto.empty(), note};
}

std::string tolerance_text(double tolerance) {
  return tolerance > 0 ? fmt::format("{:.0e}", tolerance) : "0";
}

std::string name_of(const Variant& v) {
  const std::string precision = v.scalar == "double" ? "" : ", " + v.scalar;
  const std::string certificate = v.certificate.empty() ? "" : " + " + v.certificate;
  return v.method + precision + certificate;
}

}  // namespace plumb::reports
