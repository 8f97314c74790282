// The geometric potential's two problems, each turned into one over directions.
//
// deepest points  see quotient.hpp.
// midway          G = g^n1 - 1 of each body equal, gradients opposite: body 1 grown by s^(1/n1) about its centre, and body 2 by s^(1/n1') about
//                 its own, touch at that point. s from Newton's method on the overlap of the grown bodies, which is to be 0.
#include "truth.hpp"

namespace second_opinion {
namespace {

constexpr double slack = 1e-9;

/// nullopt: several are as low, or it is not proved that none is lower.
std::optional<Minimum> only_minimum(const Pair<Quad>& pair, Question question) {
  const Directions found = search(narrow(pair), question, slack);
  const std::vector<Minimum> all = minima(pair, question, found, 3);
  if (!found.complete || all.size() != 1) return std::nullopt;
  return all.front();
}

Pair<Quad> grown(const Pair<Quad>& pair, Quad s) {
  Pair<Quad> out = pair;
  out.first.axes = power(s, 1 / pair.first.n1) * pair.first.axes;
  out.second.axes = power(s, 1 / pair.second.n1) * pair.second.axes;
  return out;
}

/// How fast the grown bodies' overlap rises with log s, at its own direction.
Quad rise(const Pair<Quad>& at, const Vec<Quad>& n) {
  return at.first.support(n).value / at.first.n1 + at.second.support(n).value / at.second.n1;
}

struct Touching {
  Minimum at;
  Pair<Quad> bodies;
};

std::optional<Touching> touching(const Pair<Quad>& pair) {
  const double near = 0.1, most_step = 2;
  const int searched = 2;  // the steps after begin with the direction of the one before
  const Quad enough = 1e-30;
  Quad log_s = 0;
  Vec<Quad> n{};
  for (int step = 0; step < 60; ++step) {
    const Pair<Quad> bodies = grown(pair, expq(log_s));
    std::optional<Minimum> found;
    if (step >= searched) {
      found = refine(bodies, Question::common_normal, n, near);
    } else {
      const auto all =
          minima(bodies, Question::common_normal, search(narrow(bodies), Question::common_normal, slack), 1);
      found = all.front();
    }
    n = found->normal;
    const Quad by = -found->value / rise(bodies, n);
    if (fabsq(by) < enough) return Touching{*found, bodies};
    log_s += std::min(std::max(by, Quad(-most_step)), Quad(most_step));
  }
  return std::nullopt;
}

/// The last place of the line x + t n inside a body, seen from its centre; nullopt: the line misses it.
std::optional<Quad> way_out(const Body<Quad>& body, const Vec<Quad>& x, const Vec<Quad>& n) {
  const Quad reach = 4 * (length(x) + largest(body.axes));
  const auto slope_at = [&](Quad t) { return dot(body.gauge(x + t * n).slope, n); };
  Quad low = -reach, high = reach;
  const int halvings = 130;
  for (int i = 0; i < halvings; ++i) (slope_at((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  if (body.gauge(x + low * n).value > 1) return std::nullopt;
  high = reach;
  for (int i = 0; i < halvings; ++i) (body.gauge(x + (low + high) / 2 * n).value < 1 ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace

std::optional<Minimum> deepest_points(const Pair<Quad>& pair) {
  const auto first = only_minimum(pair, Question::deepest_of_first),
             second = only_minimum(pair, Question::deepest_of_second);
  // Where faces lie flat upon each other no single point is the deepest.
  const double flat = 1e-14;
  if (!first || !second || std::max(first->loose, second->loose) > flat) return std::nullopt;
  const Vec<Quad> d = first->point1 - second->point1;
  const bool inside = pair.second.gauge(first->point1 - pair.apart).value < 1;
  const Quad overlap = (inside ? 1 : -1) * length(d);
  return Minimum{(1 / overlap) * d, overlap, first->point1, second->point1, std::max(first->loose, second->loose)};
}

std::optional<Vec<Quad>> midway_point(const Pair<Quad>& pair) {
  const auto found = touching(pair);
  return found ? std::optional(found->at.point1) : std::nullopt;
}

std::optional<Minimum> midway(const Pair<Quad>& pair) {
  const auto found = touching(pair);
  if (!found) return std::nullopt;
  const Vec<Quad>&n = found->at.normal, &x = found->at.point1;
  const auto first = way_out(pair.first, x, n), second = way_out(pair.second, x - pair.apart, -n);
  if (!first || !second) return std::nullopt;
  return Minimum{n, *first + *second, x + *first * n, x - *second * n, found->at.loose};
}

}  // namespace second_opinion
