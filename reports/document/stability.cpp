#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

constexpr std::array kCounted{"cases", "right", "lost", "wrong"};

void refuse_bad_sums(Json&, Json& row, const Field& line) {
  for (std::size_t i = 0; i < row["cases"].size(); ++i) {
    const auto at = [&](const char* field) { return row[field][i].get<std::int64_t>(); };
    if (at("right") + at("lost") + at("wrong") > at("cases"))
      line.member("cases").fail("step " + std::to_string(i + 1) + " has more answers than cases");
  }
}

Json& total_of(Json& totals, const Json& row) {
  const auto is_same = [&](const Json& known) {
    return known["method"] == row["method"] && known["arithmetic"] == row["arithmetic"];
  };
  const auto found = std::find_if(totals.begin(), totals.end(), is_same);
  if (found != totals.end()) return *found;
  totals.push_back({{"method", row["method"]}, {"arithmetic", row["arithmetic"]}});
  for (const char* counts : kCounted) totals.back()[counts] = 0;
  return totals.back();
}

/// Over all ladders, by method and arithmetic.
void add_totals(Json& section) {
  Json& totals = section["totals"] = Json::array();
  for (const Json& ladder : section["ladders"])
    for (const Json& row : ladder["rows"]) {
      Json& total = total_of(totals, row);
      for (const char* counts : kCounted)
        for (const Json& n : row[counts]) total[counts] = total[counts].get<std::int64_t>() + n.get<std::int64_t>();
    }
}

std::string stability_list(const Json& stability) {
  std::string out =
      fmt::format("\n### Stability, commit {}{}\n\n", shown_text(stability["commit"]), incomplete_mark(stability));
  for (const Json& total : stability["totals"])
    out += fmt::format("- {} in {}: right in {} of {} cases, {} lost, {} wrong\n", shown_text(total["method"]),
                       shown_text(total["arithmetic"]), total["right"].dump(), total["cases"].dump(),
                       total["lost"].dump(), total["wrong"].dump());
  return out;
}

}  // namespace

Section stability_section() {
  return {"stability", "Stability", false, {{"row", refuse_bad_sums}}, add_totals, stability_list};
}

}  // namespace plumb::reports
