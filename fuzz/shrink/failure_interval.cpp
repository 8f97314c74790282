#include "fuzz/shrink/failure_interval.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace plumb {
namespace {

constexpr int kRungs = 5;        ///< on either side, before bisection
constexpr int kInside = 5;       ///< probes between the ends that bisection found
constexpr double kSharp = 0.02;  ///< of the distance from the value: how near an end is known

/// A short decimal strictly between two values, near a share of the way from a to b.
double between(double a, double b, double share) {
  const double aim = a + share * (b - a), room = std::min(std::abs(aim - a), std::abs(b - aim)) / 2;
  for (int digits = 1; digits < 17; ++digits) {
    const double x = rounded(aim, digits);
    if (std::abs(x - aim) < room) return x;
  }
  return aim;
}

/// From the value outwards to the end.
std::vector<double> rungs(double value, double end, bool by_ratio) {
  std::vector<double> out;
  for (int k = 1; k < kRungs; ++k) {
    const double share = static_cast<double>(k) / kRungs;
    const double x = by_ratio ? value * std::pow(end / value, share) : value + share * (end - value);
    out.push_back(rounded(x, 2));
  }
  out.push_back(end);
  const bool up = end > value;
  std::erase_if(out, [&](double x) { return up ? x <= value || x > end : x >= value || x < end; });
  return out;
}

struct Probed {
  double low, high;
  bool by_ratio;
};

Probed probed(const Number& number, double size) {
  const double v = number.value;
  switch (number.quantity) {
    case Quantity::length: return {rounded(v / 10, 15), rounded(v * 10, 15), true};
    case Quantity::exponent: return {1.1, 50, true};
    case Quantity::zenith: return {0, 180, false};
    case Quantity::angle: return {v - 180, v + 180, false};
    case Quantity::ratio:
      if (v == 0) return {-0.5, 0.5, false};
      return v > 0 ? Probed{rounded(v / 1000, 15), std::max(v, 0.9), true}
                   : Probed{std::min(v, -10.0), rounded(v / 1000, 15), true};
    case Quantity::other: break;
  }
  return {v - size, v + size, false};
}

/// One number, and where along it the finding was looked for.
class Line {
 public:
  Line(const Described& described, Number number, Trials& trials)
      : described_(described), number_(std::move(number)), trials_(trials), tried_{{number_.value, true}} {
    const std::optional<Pair> own = pair_of(described_);
    stays_inside_ = own && in_domain(*own);
  }

  [[nodiscard]] Range range() {
    const Probed ends = probed(number_, size_of(described_.pair));
    const bool low_is_reached = reach(ends.low, ends.by_ratio), high_is_reached = reach(ends.high, ends.by_ratio);
    for (int round = 0; round < 3; ++round) {
      for (const bool up : {false, true}) sharpen(up);
      if (!gap_inside()) break;
    }
    return result(low_is_reached, high_is_reached);
  }

 private:
  using Tried = std::map<double, bool>;

  /// Outwards until the finding is gone or nothing is left to probe; false where trials were over before.
  bool reach(double end, bool by_ratio) {
    for (const double x : rungs(number_.value, end, by_ratio))
      if (!persists(x)) break;
    return !trials_.is_over();
  }

  /// False also where there is no such case in the domain, the end of what can be probed, and where trials are over; neither is kept.
  bool persists(double x) {
    if (const auto known = tried_.find(x); known != tried_.end()) return known->second;
    Described changed = described_;
    number_.set(changed, x);
    const std::optional<Pair> pair = pair_of(changed);
    if (!pair || (stays_inside_ && !in_domain(*pair)) || trials_.is_over()) return false;
    const bool there = trials_.of(*pair).judgement.finding.kind != FindingKind::none;
    if (!there && trials_.is_over()) return false;  // the trial may not have come to its end
    return tried_[x] = there;
  }

  /// The last value outwards up to which all have the finding, and the first without it.
  [[nodiscard]] std::pair<double, std::optional<double>> end(bool up) const {
    std::pair<double, std::optional<double>> out{number_.value, std::nullopt};
    const auto step = [&](double x, bool there) {
      if (there) out.first = x;
      if (!there) out.second = x;
      return there;
    };
    const auto own = tried_.find(number_.value);
    if (up)
      for (auto at = own; at != tried_.end() && step(at->first, at->second);) ++at;
    else
      for (auto at = std::make_reverse_iterator(std::next(own)); at != tried_.rend() && step(at->first, at->second);)
        ++at;
    return out;
  }

  /// Bisection; by factors of ten towards the value itself while nothing but that is known to have the finding.
  void sharpen(bool up) {
    const double v = number_.value, nothing = 1e-9 * (1 + std::abs(v));
    while (!trials_.is_over()) {
      const auto [there, gone] = end(up);
      if (!gone || std::abs(*gone - there) <= kSharp * std::abs(*gone - v)) return;
      if (there == v && std::abs(*gone - v) <= nothing) return;
      const double middle = between(there, *gone, there == v ? 0.1 : 0.5);
      (void)persists(middle);
      if (!tried_.contains(middle)) return;
    }
  }

  /// Whether the finding is missing somewhere between the ends.
  bool gap_inside() {
    const double low = end(false).first, high = end(true).first, golden = 0.6180339887498949;
    if (!(low < high)) return false;
    bool all = true;
    for (int k = 1; k <= kInside && !trials_.is_over(); ++k)
      all = persists(between(low, high, std::fmod(k * golden, 1))) && all;
    return !all;
  }

  [[nodiscard]] Range result(bool low_is_reached, bool high_is_reached) const {
    const auto [low, gone_below] = end(false);
    const auto [high, gone_above] = end(true);
    return {number_,
            low,
            high,
            gone_below,
            gone_above,
            !gone_below && low_is_reached,
            !gone_above && high_is_reached,
            tried_.size(),
            !trials_.is_over()};
  }

  const Described& described_;
  Number number_;
  Trials& trials_;
  Tried tried_;
  bool stays_inside_ = true;  ///< the domain, where the case is in it
};

}  // namespace

std::vector<Range> find_ranges(const Shrunk& shrunk, const Solver& solver, TrialCounts& counts) {
  Trials trials(solver, shrunk.found.judgement.finding.kind, false, shrunk.accuracy);
  std::vector<Range> out;
  std::vector<Number> numbers = numbers_of(shrunk.described);
  for (Number& number : numbers) {
    trials.take_a_share_of(numbers.size() - out.size());  // what the first leaves is the others'
    out.push_back(Line(shrunk.described, std::move(number), trials).range());
  }
  counts.solved += trials.counts().solved;
  counts.judged += trials.counts().judged;
  counts.work += trials.counts().work;
  return out;
}

}  // namespace plumb
