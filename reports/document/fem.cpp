#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/document/sections.hpp"

namespace plumb::reports {
namespace {

/// With how many answers it was asked of, and how many hold: so far none.
void uncount(Json& what) {
  what.update({{"held", 0}, {"of", 0}});
}

/// Each bound of CN holds above the overlap ratio of the one before it, up to its own. The commit stands beside the versions.
void finish_run(Json&, Json& fem, const Field& line) {
  fem["host"].erase("commit");
  double above = 0;
  const std::vector<Field> bounds = line.member("limits").member("cn").elements();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    Json& bound = fem["asked"]["cn"][i];
    bound["above"] = above;
    if (!(bound["ratio"] > above)) bounds[i].member("ratio").fail("must be above the one before it");
    above = bound["ratio"];
    uncount(bound);
  }
  uncount(fem["asked"]["gp"]);
}

void refuse_flat(Json&, Json& geometry, const Field& line) {
  for (std::size_t i = 0; i < 2; ++i)
    for (const Json& axis : geometry["bodies"][i]["semi_axes"])
      if (!(axis > 0)) line.member("bodies").element(i, 2, "bodies").member("semi_axes").fail("must be above 0");
}

void judge_check(Json&, Json& check, const Field&) {
  check["within"] = check["value"] <= check["limit"];
}

/// NaN: the method has no answer.
double angle_to(const Json& answer, const char* method) {
  const auto found = answer["angles_deg"].find(method);
  return found == answer["angles_deg"].end() || found->is_null() ? std::nan("") : found->get<double>();
}

Json counted(Json& what, bool held) {
  what["of"] = what["of"].get<int>() + 1;
  what["held"] = what["held"].get<int>() + (held ? 1 : 0);
  return held;
}

/// Whether CN is as near as is asked at this ratio; null where nothing is.
Json cn_within(Json& bounds, const Json& answer) {
  for (Json& bound : bounds)
    if (answer["ratio"] <= bound["ratio"])
      return counted(bound, angle_to(answer, "auto") < bound["below_deg"].get<double>());
  return nullptr;
}

/// Whether GP is as much further off as is asked; without an answer it is not. Null where it and CN are too near to each other.
Json gp_beyond(Json& asked, const Json& answer) {
  const Json& apart = answer["cn_to_gp_deg"];
  if (apart.is_null()) return counted(asked, false);
  if (!(apart > asked["apart_deg"])) return nullptr;
  const double times = asked["times"].get<double>();
  return counted(asked, angle_to(answer, "geometric_potential") > times * angle_to(answer, "auto"));
}

void judge_answer(Json& fem, Json& answer, const Field&) {
  answer["cn_within"] = cn_within(fem["asked"]["cn"], answer);
  answer["gp_beyond"] = gp_beyond(fem["asked"]["gp"], answer);
}

/// How many times the gap is as curved on the far side as where the pressure's centre has moved; null where that is not known.
void add_bends(Json&, Json& plane, const Field&) {
  const Json& curvatures = plane["curvatures"];
  const bool is_known = !curvatures.is_null() && curvatures[2] != 0;
  plane["bends"] = is_known ? Json(curvatures[0].get<double>() / curvatures[2].get<double>()) : Json();
}

std::string fem_held(const Json& asked) {
  const auto of = [](const Json& what) { return fmt::format("{} of {}\n", what["held"].dump(), what["of"].dump()); };
  std::string out;
  for (const Json& bound : asked["cn"])
    out += fmt::format("- overlap ratio above {} up to {}: force less than {} degrees from CN in {}",
                       bound["above"].get<double>(), bound["ratio"].get<double>(), bound["below_deg"].get<double>(),
                       of(bound));
  const Json& gp = asked["gp"];
  return out + fmt::format("- where GP is more than {} degrees from CN, or has no answer: more than {} times as far "
                           "from the force in {}",
                           gp["apart_deg"].get<double>(), gp["times"].get<double>(), of(gp));
}

std::string checks_lines(const Json& checks) {
  const auto within = std::count_if(checks.begin(), checks.end(), [](const Json& c) { return c["within"] == true; });
  std::string out = fmt::format("- checks within their limits: {} of {}\n", within, checks.size());
  for (const Json& check : checks)
    if (check["within"] != true)
      out += fmt::format("- **check {}**: {} {}, limit {}\n", shown_text(check["check"]), check["value"].get<double>(),
                         shown_text(check["unit"]), check["limit"].get<double>());
  return out;
}

std::string fem_list(const Json& fem) {
  std::string out =
      fmt::format("\n### Against finite elements, CalculiX {}, commit {}, {}{}\n\n", shown_text(fem["host"]["ccx"]),
                  shown_text(fem["commit"]), shown_text(fem["mode"]), incomplete_mark(fem));
  out += fem_held(fem["asked"]) + checks_lines(fem["checks"]);
  return fem["unanswered"].empty() ? out : out + fmt::format("- without an answer: {}\n", fem["unanswered"].size());
}

}  // namespace

Section fem_section() {
  return {"fem",
          "Fem",
          true,
          {{"run", finish_run},
           {"geometry", refuse_flat},
           {"check", judge_check},
           {"answer", judge_answer},
           {"half_space", add_bends}},
          nullptr,
          fem_list};
}

}  // namespace plumb::reports
