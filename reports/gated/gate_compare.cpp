#include "reports/gated/gate_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/json/number_text.hpp"

namespace plumb::reports {
namespace {

/// The lines of one row.
class Deviations {
 public:
  explicit Deviations(const GateRow& row) : row_(row) {}

  void add(std::string_view measure, const std::string& wanted, const std::string& measured, bool is_worse) {
    lines_.push_back(fmt::format("{} {} {}: {} in the table, {} measured: {}", row_.family, row_.method, measure,
                                 wanted, measured,
                                 is_worse ? "worse" : "better, plumb report-gate --update records it"));
  }
  void compare_counts(std::string_view measure, std::uint64_t wanted, std::uint64_t measured, bool more_is_worse) {
    if (wanted != measured)
      add(measure, fmt::format("{}", wanted), fmt::format("{}", measured), (measured > wanted) == more_is_worse);
  }
  void compare_errors(std::string_view measure, double wanted, double measured) {
    if (!is_within(measured, wanted))
      add(measure, error_text(wanted), fmt::format("{:.3g}", measured), std::isnan(measured) || measured > wanted);
  }
  /// 0, which is nowhere, is beyond the last.
  void compare_steps(std::uint64_t wanted, std::uint64_t measured) {
    const auto text = [](std::uint64_t step) { return step == 0 ? "nowhere" : fmt::format("step {}", step); };
    add("lets_go", text(wanted), text(measured), measured - 1 < wanted - 1);
  }
  [[nodiscard]] std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  const GateRow& row_;
  std::vector<std::string> lines_;
};

std::uint64_t count_of(const GateRow& row, FindingKind kind) {
  const auto found = row.findings.find(kind);
  return found == row.findings.end() ? 0 : found->second;
}

double two_digits(double x) {
  return number_from<double>(fmt::format("{:.1e}", x)).value_or(x);
}

/// No angle is beyond 180 degrees.
double bound_for(std::string_view measure, double measured) {
  if (!(measured > 0)) return measured;
  const double bound = two_digits(std::numbers::sqrt2 * measured);
  return measure.starts_with("angle") ? std::min(180.0, bound) : bound;
}

}  // namespace

bool is_within(double measured, double e) {
  if (std::isnan(measured) || std::isnan(e)) return std::isnan(measured) && std::isnan(e);
  return e == 0 ? measured == 0 : measured > e / 2 && measured <= e;
}

std::vector<std::string> deviations(const GateRow& wanted, const GateRow& measured) {
  Deviations out(wanted);
  out.compare_counts("judged", wanted.judged, measured.judged, false);
  out.compare_counts("converged", wanted.converged, measured.converged, false);
  for (std::size_t i = 0; i < error_names.size(); ++i)
    out.compare_errors(error_names[i], wanted.errors[i], measured.errors[i]);
  for (int i = 0; i < static_cast<int>(FindingKind::none); ++i) {
    const auto kind = static_cast<FindingKind>(i);
    out.compare_counts(name(kind), count_of(wanted, kind), count_of(measured, kind), true);
  }
  if (wanted.lets_go != measured.lets_go) out.compare_steps(wanted.lets_go, measured.lets_go);
  return std::move(out).lines();
}

GateRow updated(const GateRow* before, const GateRow& measured) {
  GateRow out = measured;
  for (std::size_t i = 0; i < error_names.size(); ++i) {
    const bool holds = before != nullptr && is_within(measured.errors[i], before->errors[i]);
    out.errors[i] = holds ? before->errors[i] : bound_for(error_names[i], measured.errors[i]);
  }
  return out;
}

}  // namespace plumb::reports
