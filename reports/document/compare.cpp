#include "reports/document/compare.hpp"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

namespace plumb::reports {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Difference {
  std::string measure;
  const char* unit;
  double before, after;
  bool more_is_better;
  double p;  ///< NaN: no test
  Share before_share{kNone, kNone, kNone}, after_share{kNone, kNone, kNone};
};

Difference share_row(const std::string& measure, std::uint64_t k1, std::uint64_t n1, std::uint64_t k2, std::uint64_t n2,
                     bool more_is_better) {
  const Share one = share_of(k1, n1), two = share_of(k2, n2);
  return {measure, "share", one.share, two.share, more_is_better, fisher_p(k1, n1, k2, n2), one, two};
}

void add_shares(std::vector<Difference>& rows, const Tally& one, const Tally& two) {
  rows.push_back(share_row("converged", one.converged(), one.cases, two.converged(), two.cases, true));
  for (std::size_t i = 0; i < kFindingKinds; ++i) {
    const auto kind = static_cast<FindingKind>(i);
    if (one.findings[i] + two.findings[i] == 0) continue;
    const std::string word = kind == FindingKind::none ? "right" : std::string(name(kind));
    rows.push_back(
        share_row(word, one.findings[i], one.judged(), two.findings[i], two.judged(), kind == FindingKind::none));
  }
  rows.push_back(share_row("unjudged", one.unjudged, one.cases, two.unjudged, two.cases, false));
  rows.push_back(share_row("off by 0.01 deg", one.angles_wrong, one.angle_error_deg.count(), two.angles_wrong,
                           two.angle_error_deg.count(), false));
}

/// The middle by the whole distribution, the tail by the share of answers beyond the p99 of both runs together.
void add_percentiles(std::vector<Difference>& rows, const std::string& measure, const char* unit, const Histogram& one,
                     const Histogram& two) {
  if (one.count() == 0 || two.count() == 0) return;
  rows.push_back({measure + " p50", unit, one.percentile(0.5), two.percentile(0.5), false, mann_whitney_p(one, two)});
  rows.push_back({measure + " p99", unit, one.percentile(0.99), two.percentile(0.99), false, tail_p(one, two)});
}

std::vector<Difference> rows_of(const Tally& one, const Tally& two) {
  std::vector<Difference> rows;
  add_shares(rows, one, two);
  add_percentiles(rows, "angle_error_deg", "deg", one.angle_error_deg, two.angle_error_deg);
  add_percentiles(rows, "overlap_error", "relative", one.overlap_error, two.overlap_error);
  add_percentiles(rows, "iterations", "count", one.iterations, two.iterations);
  add_percentiles(rows, "evaluations", "count", one.evaluations, two.evaluations);
  return rows;
}

bool is_same(const Difference& r) {
  return r.before == r.after;
}

/// A share of no answers, on either side, is nothing to compare.
bool is_comparable(const Difference& r) {
  return !std::isnan(r.before) && !std::isnan(r.after);
}

const char* verdict(const Difference& r, bool same_cases) {
  constexpr double significant = 0.05;
  if (is_same(r)) return "same";
  if (!same_cases && !(r.p < significant)) return "noise";
  return (r.after > r.before) == r.more_is_better ? "better" : "worse";
}

Json row_json(const std::string& family, const std::string& method, const Difference& r, bool same_cases) {
  Json out{{"family", family},
           {"method", method},
           {"measure", r.measure},
           {"unit", r.unit},
           {"before", number_json(r.before)},
           {"after", number_json(r.after)},
           {"p", same_cases ? Json() : number_json(r.p)},
           {"verdict", verdict(r, same_cases)}};
  if (r.unit == std::string_view("share")) {
    out["before_interval"] = {number_json(r.before_share.low), number_json(r.before_share.high)};
    out["after_interval"] = {number_json(r.after_share.low), number_json(r.after_share.high)};
  }
  return out;
}

struct Compared {
  std::string family, method;
  Difference row;
};

std::vector<Compared> compare(const Results& before, const Results& after) {
  std::vector<Compared> out;
  for (const std::string& family : family_order(before)) {
    const auto other = after.families.find(family);
    if (other == after.families.end()) continue;
    const Tallies& methods = before.families.at(family).methods;
    for (const std::string& method : method_order(methods)) {
      const auto again = other->second.methods.find(method);
      if (again == other->second.methods.end()) continue;
      for (Difference& row : rows_of(methods.at(method), again->second))
        if (is_comparable(row)) out.push_back({family, method, std::move(row)});
    }
  }
  return out;
}

void adjust(std::vector<Compared>& rows) {
  std::vector<double> p;
  for (const Compared& c : rows) p.push_back(is_same(c.row) ? kNone : c.row.p);
  adjust_by_holm(p);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].row.p = p[i];
}

/// Both in the bins of either.
std::map<int, std::array<double, 2>> counts_by_bin(const Histogram& one, const Histogram& two) {
  std::map<int, std::array<double, 2>> out;
  for (const auto& [bin, n] : one.bins()) out[bin][0] += static_cast<double>(n);
  for (const auto& [bin, n] : two.bins()) out[bin][1] += static_cast<double>(n);
  return out;
}

}  // namespace

double fisher_p(std::uint64_t k1, std::uint64_t n1, std::uint64_t k2, std::uint64_t n2) {
  const std::uint64_t k = k1 + k2, n = n1 + n2;
  if (n1 == 0 || n2 == 0 || k == 0 || k == n) return 1;
  const auto whole = [](std::uint64_t x) { return static_cast<unsigned>(x); };
  const boost::math::hypergeometric_distribution<double> drawn(whole(k), whole(n1), whole(n));
  const double at_most = cdf(drawn, whole(k1)), more = cdf(complement(drawn, whole(k1)));
  const double exactly = pdf(drawn, whole(k1));
  return std::min(1.0, 2 * std::min(at_most, more + exactly));
}

double mann_whitney_p(const Histogram& one, const Histogram& two) {
  const double n1 = static_cast<double>(one.count()), n2 = static_cast<double>(two.count()), n = n1 + n2;
  double below = 0, rank_sum = 0, ties = 0;
  for (const auto& [bin, counts] : counts_by_bin(one, two)) {
    const double here = counts[0] + counts[1];
    rank_sum += counts[0] * (below + (here + 1) / 2);
    ties += here * (here * here - 1);
    below += here;
  }
  const double variance = n1 * n2 / 12 * (n + 1 - ties / (n * (n - 1)));
  if (!(variance > 0)) return 1;
  const double off = std::abs(rank_sum - n1 * (n + 1) / 2) - 0.5;  // continuity
  const double z = std::max(0.0, off) / std::sqrt(variance);
  return 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

double tail_p(const Histogram& one, const Histogram& two) {
  Histogram both = one;
  both.merge(two);
  const double edge = both.percentile(0.99);
  return fisher_p(one.above(edge), one.count(), two.above(edge), two.count());
}

void adjust_by_holm(std::vector<double>& p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!std::isnan(p[i])) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double adjusted = static_cast<double>(order.size() - i) * p[order[i]];
    p[order[i]] = least = std::min(1.0, std::max(least, adjusted));
  }
}

bool had_same_cases(const Results& one, const Results& two) {
  if (one.incomplete() || two.incomplete() || one.families.size() != two.families.size()) return false;
  return std::all_of(one.families.begin(), one.families.end(), [&](const auto& entry) {
    const auto other = two.families.find(entry.first);
    return other != two.families.end() && other->second.cases == entry.second.cases &&
           other->second.digest == entry.second.digest;
  });
}

Json comparison_json(const Run& before, const Run& after) {
  const bool same_cases = had_same_cases(before.results, after.results);
  std::vector<Compared> compared = compare(before.results, after.results);
  adjust(compared);
  Json rows = Json::array();
  for (const Compared& c : compared) rows.push_back(row_json(c.family, c.method, c.row, same_cases));
  return {
      {"before", before.folder.string()}, {"after", after.folder.string()}, {"same_cases", same_cases}, {"rows", rows}};
}

}  // namespace plumb::reports
