#include <fmt/format.h>

#include <cstdint>

#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

void refuse_more_ends(Json&, Json& pair, const Field& line) {
  std::int64_t ends = pair["not_converged"].get<std::int64_t>() + pair["elsewhere"].get<std::int64_t>();
  for (const Json& root : pair["roots"]) ends += root["starts"].get<std::int64_t>();
  if (ends > pair["starts"]) line.member("starts").fail("is below the number of their ends");
}

std::string study_list(const Json& study) {
  std::string out =
      fmt::format("\n### The source's study, commit {}{}\n\n", shown_text(study["commit"]), incomplete_mark(study));
  for (const Json& share : study["shares"])
    out += fmt::format("- {}, aspect {}, overlap ratio {}: {} of {} answers more than 0.01 degrees off, {} pairs\n",
                       shown_text(share["method"]), share["aspect"].get<double>(), share["ratio"].get<double>(),
                       share["off"].dump(), share["answers"].dump(), share["pairs"].dump());
  return out;
}

}  // namespace

Section study_section() {
  return {"study", "Study", true, {{"roots", refuse_more_ends}}, nullptr, study_list};
}

}  // namespace plumb::reports
