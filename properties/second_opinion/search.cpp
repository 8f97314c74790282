#include "search.hpp"

#include <limits>
#include <queue>

namespace second_opinion {
namespace {

/// About a second a million; what needs more has a valley or a ring of directions that are all as low.
constexpr int most_triangles = 30000;

struct Triangle {
  std::array<Vec<double>, 3> corners;
  Candidate middle;
  double lower;  ///< no direction in it is lower
};
struct HigherLast {
  bool operator()(const Triangle& a, const Triangle& b) const { return a.lower > b.lower; }
};

class Search {
 public:
  Search(const Pair<double>& pair, Question question, double slack)
      : pair_(pair), question_(question), relative_(slack) {}

  Directions run() {
    start();
    int looked = 0;
    for (; !open_.empty() && looked < most_triangles; ++looked) {
      const Triangle lowest = open_.top();
      if (lowest.lower > best_ + slack()) break;
      open_.pop();
      if (lowest.middle.value - lowest.lower <= slack()) {
        keep(lowest);
      } else {
        divide(lowest);
      }
    }
    return finish(looked == most_triangles);
  }

 private:
  [[nodiscard]] double slack() const { return relative_ * std::max(1.0, std::fabs(best_)); }

  /// A support function is above its tangent planes and below its chords. Both of top and bottom are linear between the corners then, and
  /// their quotient is least at one: top's plane over bottom's chord where top is positive, over bottom's plane where it is not.
  [[nodiscard]] Triangle bounded(const std::array<Vec<double>, 3>& corners) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Vec<double> n = unit(corners[0] + corners[1] + corners[2]);
    const Seen<double> seen = look(pair_, question_, n);
    double over_chord = infinity, over_plane = infinity, radius = 0;
    for (const Vec<double>& corner : corners) {
      const double top = dot(corner, seen.top_slope), plane = dot(corner, seen.bottom_slope);
      const double chord = question_ == Question::common_normal ? 1 : look(pair_, question_, corner).bottom;
      over_chord = std::min(over_chord, top / chord);
      over_plane = std::min(over_plane, plane > 0 ? top / plane : -infinity);
      radius = std::max(radius, length(corner - n));
    }
    best_ = std::min(best_, seen.value);
    return {corners, {n, seen.value, radius}, over_chord >= 0 ? over_chord : over_plane};
  }

  void start() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    const std::array<Vec<double>, 12> v{{{-1, g, 0},
                                         {1, g, 0},
                                         {-1, -g, 0},
                                         {1, -g, 0},
                                         {0, -1, g},
                                         {0, 1, g},
                                         {0, -1, -g},
                                         {0, 1, -g},
                                         {g, 0, -1},
                                         {g, 0, 1},
                                         {-g, 0, -1},
                                         {-g, 0, 1}}};
    constexpr std::array<std::array<std::size_t, 3>, 20> faces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (const auto& [a, b, c] : faces) open_.push(bounded({unit(v[a]), unit(v[b]), unit(v[c])}));
  }

  void divide(const Triangle& t) {
    const auto& [a, b, c] = t.corners;
    const Vec<double> ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
    for (const auto& corners :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      open_.push(bounded(corners));
  }

  void keep(const Triangle& t) {
    kept_.push_back(t.middle);
    kept_lower_ = std::min(kept_lower_, t.lower);
  }

  [[nodiscard]] Directions finish(bool given_up) {
    Directions out;
    out.slack = slack();
    out.complete = !given_up;
    out.proven = std::min(kept_lower_, open_.empty() ? kept_lower_ : open_.top().lower);
    for (; given_up && !open_.empty(); open_.pop()) kept_.push_back(open_.top().middle);
    for (const Candidate& c : kept_)
      if (c.value <= best_ + 2 * out.slack) out.low.push_back(c);
    std::sort(out.low.begin(), out.low.end(), [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
    return out;
  }

  const Pair<double>& pair_;
  Question question_;
  double relative_;
  double best_ = std::numeric_limits<double>::infinity(), kept_lower_ = best_;
  std::priority_queue<Triangle, std::vector<Triangle>, HigherLast> open_;
  std::vector<Candidate> kept_;
};

}  // namespace

Directions search(const Pair<double>& pair, Question question, double slack) {
  return Search(pair, question, slack).run();
}

}  // namespace second_opinion
