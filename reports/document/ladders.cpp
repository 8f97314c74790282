#include "reports/document/document.hpp"

namespace plumb::reports {
namespace {

/// One figure of every step.
template <class Figure>
Json by_step(const StepRow& row, const Figure& figure) {
  Json out = Json::array();
  for (const StepCounts& step : row) out.push_back(figure(step));
  return out;
}

/// The findings that there are, by their words.
Json findings_by_step(const StepRow& row) {
  Json out = Json::object();
  for (std::size_t i = 0; i + 1 < kFindingKinds; ++i) {
    const auto kind = static_cast<FindingKind>(i);
    std::uint64_t all = 0;
    for (const StepCounts& step : row) all += step.of(kind);
    if (all > 0) out[std::string(name(kind))] = by_step(row, [&](const StepCounts& step) { return step.of(kind); });
  }
  return out;
}

Json ladder_row_json(const std::string& method, bool published, const StepRow& row) {
  const auto lost = [](const StepCounts& step) { return step.of(FindingKind::nonconverged); };
  const auto step = lets_go(row);
  return {{"method", method},
          {"published", published},
          {"answers", by_step(row, [](const StepCounts& s) { return s.answers; })},
          {"judged", by_step(row, [](const StepCounts& s) { return s.judged(); })},
          {"not_converged", by_step(row, [](const StepCounts& s) { return s.not_converged; })},
          {"lost", by_step(row, lost)},
          {"wrong", by_step(row, [&](const StepCounts& s) { return s.failures() - lost(s); })},
          {"findings", findings_by_step(row)},
          {"lets_go", step ? Json(*step + 1) : Json()}};
}

}  // namespace

Json ladders_json(const Results& results) {
  Json out = Json::array();
  for (const auto& [family_name, family] : results.families)
    for (const std::string& name : ladder_order(family.ladders)) {
      const Ladder& ladder = family.ladders.at(name);
      const Tallies& whole = family.generators.at(name);
      Json rows = Json::array();
      for (const std::string& method : method_order(whole))
        rows.push_back(ladder_row_json(method, whole.at(method).published, ladder.methods.at(method)));
      out.push_back({{"name", name}, {"knob", ladder.knob}, {"steps", ladder.steps}, {"methods", rows}});
    }
  return out;
}

}  // namespace plumb::reports
