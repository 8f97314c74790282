#include "refine.hpp"

#include <limits>
#include <optional>

namespace second_opinion {
namespace {

/// Quad's own epsilon is 2e-34; below this a step or a slope is rounding.
const Quad settled = 1e-29;

/// A plane of directions n0 + x e1 + y e2.
struct Chart {
  Vec<Quad> middle;
  std::array<Vec<Quad>, 2> axes;

  explicit Chart(const Vec<Quad>& n) : middle(unit(n)), axes(across(middle)) {}
  [[nodiscard]] Vec<Quad> at(Quad x, Quad y) const { return middle + x * axes[0] + y * axes[1]; }
};

struct Step {
  Quad x, y;
};

/// Newton's, with the second derivatives by differences over `width`; nullopt where they have no minimum.
std::optional<Step> newton_step(const Pair<Quad>& pair, Question question, const Chart& chart, Quad width) {
  const auto slopes = [&](Quad x, Quad y) {
    const Vec<Quad> g = slope(look(pair, question, chart.at(x, y)));
    return Step{dot(g, chart.axes[0]), dot(g, chart.axes[1])};
  };
  const Step g = slopes(0, 0), gx = slopes(width, 0), gy = slopes(0, width);
  const Quad xx = (gx.x - g.x) / width, yy = (gy.y - g.y) / width, xy = (gx.y - g.y + gy.x - g.x) / (2 * width);
  const Quad determinant = xx * yy - xy * xy;
  if (!(xx > 0) || !(determinant > 0)) return std::nullopt;
  return Step{(xy * g.y - yy * g.x) / determinant, (xy * g.x - xx * g.y) / determinant};
}

/// The part of the step that lowers f; nullopt where none does.
std::optional<Vec<Quad>> lower(const Pair<Quad>& pair, Question question, const Chart& chart, Step step) {
  const Quad before = look(pair, question, chart.middle).value;
  const Quad rounding = Quad(1e-32) * std::max(Quad(1), fabsq(before));
  Quad part = 1;
  for (int halvings = 0; halvings < 12; ++halvings, part /= 2) {
    const Vec<Quad> n = unit(chart.at(part * step.x, part * step.y));
    if (look(pair, question, n).value <= before + rounding) return n;
  }
  return std::nullopt;
}

/// nullopt: it does not converge, as beside the kinks of a support function that a body's nearly flat faces make.
std::optional<Vec<Quad>> newton(const Pair<Quad>& pair, Question question, Vec<Quad> n, double radius) {
  const Quad widest = 1e-10, narrowest = 1e-19, most = 100 * std::max(radius, 1e-12);
  Quad width = std::min(widest, Quad(radius) / 1000);
  for (int step = 0; step < 40; ++step) {
    const Chart chart(n);
    const auto found = newton_step(pair, question, chart, width);
    if (!found) return std::nullopt;
    const Quad far = std::max(fabsq(found->x), fabsq(found->y));
    if (!(far < most)) return std::nullopt;
    if (far < settled) return n;
    const auto next = lower(pair, question, chart, *found);
    if (!next) return std::nullopt;
    n = *next;
    width = std::min(widest, std::max(narrowest, far / 10000));
  }
  return std::nullopt;
}

/// Where `rise`, which grows, is 0 in [low, high]: halving for kinks, every other time the secant for where it is smooth.
template <class Rise>
Quad where_level(const Rise& rise, Quad low, Quad high) {
  Quad at_low = rise(low), at_high = rise(high);
  if (at_low >= 0) return low;
  if (at_high <= 0) return high;
  const Quad enough = 1e-31;
  for (bool is_secant = true; high - low > enough; is_secant = !is_secant) {
    const Quad wide = high - low, step = is_secant ? wide * at_low / (at_low - at_high) : wide / 2;
    const Quad x = std::min(std::max(low + step, low + wide / 1024), high - wide / 1024), r = rise(x);
    if (r == 0) return x;
    (r < 0 ? low : high) = x;
    (r < 0 ? at_low : at_high) = r;
  }
  return (low + high) / 2;
}

/// Lowest along y at that x.
Quad lowest_across(const Pair<Quad>& pair, Question question, const Chart& chart, Quad x, Quad reach) {
  return where_level([&](Quad y) { return dot(slope(look(pair, question, chart.at(x, y))), chart.axes[1]); }, -reach,
                     reach);
}

/// By the slope along x of the lowest across. Right where the chart's x runs along the kink, or there is none.
Vec<Quad> lowest_by_slope(const Pair<Quad>& pair, Question question, const Chart& chart, Quad reach) {
  const auto across_at = [&](Quad x) { return lowest_across(pair, question, chart, x, reach); };
  const Quad x =
      where_level([&](Quad at) { return dot(slope(look(pair, question, chart.at(at, across_at(at)))), chart.axes[0]); },
                  -reach, reach);
  return unit(chart.at(x, across_at(x)));
}

/// Golden section along x of the lowest across: no slope along x, which on a kink is none of f's.
Vec<Quad> lowest_by_value(const Pair<Quad>& pair, Question question, const Chart& chart, Quad reach) {
  struct Place {
    Quad x, y, value;
  };
  const auto at = [&](Quad x) {
    const Quad y = lowest_across(pair, question, chart, x, reach);
    return Place{x, y, look(pair, question, chart.at(x, y)).value};
  };
  const Quad golden = (sqrtq(Quad(5)) - 1) / 2, enough = 1e-19;
  Quad low = -reach, high = reach;
  Place left = at(high - golden * (high - low)), right = at(low + golden * (high - low));
  while (high - low > enough) {
    if (left.value <= right.value) {
      high = right.x;
      right = left;
      left = at(high - golden * (high - low));
    } else {
      low = left.x;
      left = right;
      right = at(low + golden * (high - low));
    }
  }
  const Place& best = left.value <= right.value ? left : right;
  return unit(chart.at(best.x, best.y));
}

/// A support function bends most across the planes of its body's axes: x along the plane that n is nearest to.
Chart along_a_kink(const Pair<Quad>& pair, const Vec<Quad>& n) {
  Chart chart(n);
  Quad nearest = 2;
  for (const Body<Quad>* body : {&pair.first, &pair.second})
    for (const Vec<Quad>& axis : body->frame) {
      const Quad off = fabsq(dot(axis, chart.middle));
      if (std::max(body->n1, body->n2) <= 2 || off >= nearest) continue;
      nearest = off;
      chart.axes[0] = unit(cross(axis, chart.middle));
      chart.axes[1] = cross(chart.middle, chart.axes[0]);
    }
  return chart;
}

/// All round, and along each kink near n: what lies in a fold is found on its bottom only.
std::vector<Vec<Quad>> ways_from(const Pair<Quad>& pair, const Vec<Quad>& n) {
  const Chart chart(n);
  const int ways = 8;
  const Quad near_a_kink = 1e-6;
  std::vector<Vec<Quad>> out;
  for (int k = 0; k < ways; ++k) {
    const double way = k * 2 * M_PI / ways;
    out.push_back(Quad(std::cos(way)) * chart.axes[0] + Quad(std::sin(way)) * chart.axes[1]);
  }
  for (const Body<Quad>* body : {&pair.first, &pair.second})
    for (const Vec<Quad>& axis : body->frame) {
      if (fabsq(dot(axis, n)) > near_a_kink) continue;
      out.push_back(unit(cross(axis, n)));
      out.push_back(-out.back());
    }
  return out;
}

bool is_lowest_of_its_neighbours(const Pair<Quad>& pair, Question question, const Vec<Quad>& n) {
  const Quad here = look(pair, question, n).value, rounding = Quad(1e-31) * std::max(Quad(1), fabsq(here));
  for (const Vec<Quad>& way : ways_from(pair, n))
    for (const double turn : {1e-9, 1e-12, 1e-15})
      if (look(pair, question, n + Quad(turn) * way).value < here - rounding) return false;
  return true;
}

Vec<Quad> lowest_nearby(const Pair<Quad>& pair, Question question, const Vec<Quad>& start, Quad reach) {
  const Chart chart = along_a_kink(pair, start);
  const Vec<Quad> quick = lowest_by_slope(pair, question, chart, reach);
  return is_lowest_of_its_neighbours(pair, question, quick) ? quick : lowest_by_value(pair, question, chart, reach);
}

/// Again about what was found while that lies at the border.
Vec<Quad> nested(const Pair<Quad>& pair, Question question, Vec<Quad> n, double radius) {
  const double widest = 0.5;
  Quad reach = std::min(widest, 4 * std::max(radius, 1e-12));
  for (int again = 0; again < 8; ++again) {
    const Vec<Quad> next = lowest_nearby(pair, question, n, reach);
    const bool inside = length(next - n) < reach * Quad(0.9);
    n = next;
    if (inside) break;
    reach = std::min(Quad(widest), 4 * reach);
  }
  return n;
}

/// How far a body's point turns with directions that are as good: a face as good as flat has all its points there.
struct Looseness {
  double first = 0, second = 0;
};
Looseness looseness(const Pair<Quad>& pair, Question question, const Vec<Quad>& n, const Seen<Quad>& seen) {
  const Quad turn = 1e-18;
  const Chart chart(n);
  Looseness out;
  for (const auto& [x, y] : {std::pair<Quad, Quad>{turn, 0}, {-turn, 0}, {0, turn}, {0, -turn}}) {
    const Seen<Quad> beside = look(pair, question, chart.at(x, y));
    out.first = std::max(out.first, static_cast<double>(length(beside.point1 - seen.point1)));
    out.second = std::max(out.second, static_cast<double>(length(beside.point2 - seen.point2)));
  }
  return out;
}

/// The points of a common normal are o(n) n apart, those of a deepest point are one: the better known of the two says where the other is.
Minimum minimum_at(const Pair<Quad>& pair, Question question, const Vec<Quad>& n) {
  const Seen<Quad> seen = look(pair, question, n);
  const Looseness loose = looseness(pair, question, n, seen);
  const Vec<Quad> along = question == Question::common_normal ? seen.value * n : Vec<Quad>{0, 0, 0};
  if (loose.first <= loose.second) return {n, seen.value, seen.point1, seen.point1 - along, loose.first};
  return {n, seen.value, seen.point2 + along, seen.point2, loose.second};
}

/// No ridge between that is higher over the candidate than the candidate over the minimum.
bool is_in_its_valley(const Pair<double>& pair, Question question, const Candidate& c, const Minimum& found) {
  const Vec<double> minimum = narrow(found.normal);
  if (length(c.normal - minimum) > 1) return false;
  const double most = 2 * c.value - static_cast<double>(found.value);
  const int places = 8;
  for (int i = 1; i <= places; ++i) {
    const double part = static_cast<double>(i) / (places + 1);
    const Vec<double> between = (1 - part) * c.normal + part * minimum;
    if (look(pair, question, between).value > most) return false;
  }
  return true;
}

}  // namespace

Minimum refine(const Pair<Quad>& pair, Question question, const Vec<Quad>& start, double radius) {
  const auto quick = newton(pair, question, unit(start), radius);
  return minimum_at(pair, question, quick ? *quick : nested(pair, question, unit(start), radius));
}

std::vector<Minimum> minima(const Pair<Quad>& pair, Question question, const Directions& found, std::size_t most) {
  std::vector<Minimum> out;
  const Pair<double> rough = narrow(pair);
  std::size_t refined = 0;
  for (const Candidate& start : found.low) {
    if (refined == most) break;
    const auto has = [&](const Minimum& m) { return is_in_its_valley(rough, question, start, m); };
    if (std::any_of(out.begin(), out.end(), has)) continue;
    ++refined;
    const Minimum next = refine(pair, question, widen(start.normal), start.radius);
    const Quad same = 1e-12;
    const auto is_same = [&](const Minimum& m) { return length(m.normal - next.normal) < same; };
    if (std::none_of(out.begin(), out.end(), is_same)) out.push_back(next);
  }
  std::sort(out.begin(), out.end(), [](const Minimum& a, const Minimum& b) { return a.value < b.value; });
  return out;
}

}  // namespace second_opinion
