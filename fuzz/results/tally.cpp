#include "fuzz/results/tally.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "corpus/json/number_text.hpp"
#include "fuzz/results/counts.hpp"

namespace plumb {
namespace {

constexpr int kBinsPerDecade = 20;
constexpr int kZeroBin = -10000;
constexpr int kInfiniteBin = 10000;

constexpr int kLastWhole = 100000;

int bin_of(double value, Histogram::Scale scale) {
  if (scale == Histogram::Scale::whole) return static_cast<int>(std::min(value, double{kLastWhole}));
  if (!(value > 0)) return kZeroBin;
  if (std::isinf(value)) return kInfiniteBin;
  return static_cast<int>(std::ceil(kBinsPerDecade * std::log10(value)));
}

double upper_edge(int bin, Histogram::Scale scale) {
  if (scale == Histogram::Scale::whole) return bin;
  if (bin == kZeroBin) return 0;
  if (bin == kInfiniteBin) return std::numeric_limits<double>::infinity();
  return std::pow(10.0, static_cast<double>(bin) / kBinsPerDecade);
}

int read_bin(const std::string& name, const Field& field) {
  const auto bin = number_from<int>(name);
  if (!bin) field.fail("is no number of a bin");
  return *bin;
}

template <std::size_t N>
void add_all(std::array<std::uint64_t, N>& to, const std::array<std::uint64_t, N>& from) {
  for (std::size_t i = 0; i < N; ++i) to[i] += from[i];
}

}  // namespace

void Histogram::add(double value) {
  if (std::isnan(value)) return;
  ++bins_[bin_of(value, scale_)];
  max_ = std::max(max_, value);
}

void Histogram::merge(const Histogram& other) {
  for (const auto& [bin, n] : other.bins_) bins_[bin] += n;
  max_ = std::max(max_, other.max_);
}

std::uint64_t Histogram::count() const {
  std::uint64_t n = 0;
  for (const auto& entry : bins_) n += entry.second;
  return n;
}

double Histogram::percentile(double p) const {
  const double wanted = p * static_cast<double>(count());
  std::uint64_t below = 0;
  for (const auto& [bin, n] : bins_) {
    below += n;
    if (static_cast<double>(below) >= wanted) return std::min(upper_edge(bin, scale_), max_);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::uint64_t Histogram::above(double percentile) const {
  constexpr double rounding = 1 + 1e-9;
  std::uint64_t n = 0;
  for (const auto& [bin, count] : bins_) n += upper_edge(bin, scale_) > percentile * rounding ? count : 0;
  return n;
}

Json Histogram::summary() const {
  if (bins_.empty()) return nullptr;
  return {{"p50", percentile(0.5)}, {"p99", percentile(0.99)}, {"max", max_}};
}

Json Histogram::to_json() const {
  Json bins = Json::object();
  for (const auto& [bin, n] : bins_) bins[std::to_string(bin)] = n;
  // An infinite maximum is not JSON; its bin says it.
  return {{"bins", bins}, {"max", std::isinf(max_) ? Json() : Json(max_)}};
}

void Histogram::read(const Field& field) {
  for (const auto& [name, count] : field.member("bins").members()) bins_[read_bin(name, count)] = read_count(count);
  const Field max = field.member("max");
  max_ = max.value().is_null() ? std::numeric_limits<double>::infinity() : max.number();
}

void Tally::merge(const Tally& other) {
  published = published && other.published;
  cases += other.cases;
  unjudged += other.unjudged;
  add_all(findings, other.findings);
  add_all(converged_findings, other.converged_findings);
  add_all(statuses, other.statuses);
  add_all(right, other.right);
  not_asked += other.not_asked;
  wrong_aside += other.wrong_aside;
  angles_wrong += other.angles_wrong;
  angle_error_deg.merge(other.angle_error_deg);
  overlap_error.merge(other.overlap_error);
  iterations.merge(other.iterations);
  evaluations.merge(other.evaluations);
  atlas.merge(other.atlas);
  habits.merge(other.habits);
  nanoseconds.merge(other.nanoseconds);
}

Json Tally::to_json() const {
  return {{"published", published},
          {"cases", cases},
          {"unjudged", unjudged},
          {"findings", findings},
          {"converged_findings", converged_findings},
          {"statuses", statuses},
          {"right", right},
          {"not_asked", not_asked},
          {"wrong_aside", wrong_aside},
          {"angles_wrong", angles_wrong},
          {"angle_error_deg", angle_error_deg.to_json()},
          {"overlap_error", overlap_error.to_json()},
          {"iterations", iterations.to_json()},
          {"evaluations", evaluations.to_json()},
          {"atlas", atlas.to_json()},
          {"habits", habits.to_json()},
          {"nanoseconds", nanoseconds.to_json()}};
}

namespace {

/// Each answer has one status, and one finding if it was judged.
void require_sums(const Tally& t, const Field& field) {
  const auto sum = [](const auto& counts) { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); };
  if (t.unjudged > t.cases || sum(t.findings) != t.judged())
    field.member("findings").fail("are not those of the judged answers");
  if (sum(t.statuses) != t.cases) field.member("statuses").fail("are not those of the answers");
  if (!std::is_sorted(t.right.begin(), t.right.end()) || t.right.back() > t.judged())
    field.member("right").fail("do not grow from level to level, or are more than the judged answers");
  if (t.wrong_aside > t.cases - t.converged()) field.member("wrong_aside").fail("are more than did not converge");
  if (t.angles_wrong > t.angle_error_deg.count()) field.member("angles_wrong").fail("are more than there are angles");
}

}  // namespace

Tally Tally::read(const Field& field) {
  Tally t;
  t.published = field.member("published").flag();
  t.cases = count_at(field, "cases");
  t.unjudged = count_at(field, "unjudged");
  read_counts(t.findings, field, "findings");
  read_counts(t.converged_findings, field, "converged_findings");
  read_counts(t.statuses, field, "statuses");
  read_counts(t.right, field, "right");
  t.not_asked = count_at(field, "not_asked");
  t.wrong_aside = count_at(field, "wrong_aside");
  t.angles_wrong = count_at(field, "angles_wrong");
  t.angle_error_deg.read(field.member("angle_error_deg"));
  t.overlap_error.read(field.member("overlap_error"));
  t.iterations.read(field.member("iterations"));
  t.evaluations.read(field.member("evaluations"));
  t.atlas.read(field.member("atlas"));
  t.habits = Habits::read(field.member("habits"));
  t.nanoseconds.read(field.member("nanoseconds"));
  require_sums(t, field);
  return t;
}

void add_answer(Tally& tally, const std::optional<Place>& place, const Contact<double>& answer,
                const Judgement& judgement, double nanoseconds) {
  const auto kind = static_cast<std::size_t>(judgement.finding.kind);
  const bool converged = answer.status == Status::converged, broken = judgement.finding.kind != FindingKind::none;
  const bool unjudged = !is_judged(judgement);
  ++tally.cases;
  ++tally.statuses[static_cast<std::size_t>(answer.status)];
  if (place)
    tally.atlas.add(*place, {1, unjudged ? 0u : 1u, broken ? 1u : 0u, converged ? 0u : 1u,
                             static_cast<std::uint64_t>(std::max(0, answer.iterations))});
  if (unjudged) {
    ++tally.unjudged;
  } else {
    ++tally.findings[kind];
    tally.converged_findings[kind] += converged ? 1 : 0;
    for (std::size_t i = judgement.right_from; i < tally.right.size(); ++i) ++tally.right[i];
  }
  tally.wrong_aside += judgement.wrong_aside ? 1 : 0;
  tally.iterations.add(answer.iterations);
  tally.evaluations.add(answer.evaluations);
  tally.nanoseconds.add(nanoseconds);
  if (!converged) return;
  tally.angles_wrong += judgement.angle_error_deg > kWrongAngleDeg ? 1 : 0;
  tally.angle_error_deg.add(judgement.angle_error_deg);
  tally.overlap_error.add(judgement.overlap_error);
}

Json right_json(const Tally& tally) {
  Json json = Json::object();
  for (std::size_t i = 0; i < accuracy_levels.size(); ++i) json[std::string(accuracy_levels[i].name)] = tally.right[i];
  // Slow is no error in what is said; a solver that does not come back is slow as well, and has not converged.
  json["asked"] = tally.of(FindingKind::none) + tally.converged_findings[static_cast<std::size_t>(FindingKind::slow)];
  return json;
}

Share share_of(std::uint64_t k, std::uint64_t n) {
  if (n == 0) return {std::numeric_limits<double>::quiet_NaN(), 0, 1};
  using Binomial = boost::math::binomial_distribution<double>;
  const double successes = static_cast<double>(k), trials = static_cast<double>(n);
  return {successes / trials, Binomial::find_lower_bound_on_p(trials, successes, 0.025),
          Binomial::find_upper_bound_on_p(trials, successes, 0.025)};
}

}  // namespace plumb
