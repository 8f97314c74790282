#include <array>
#include <utility>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/document/json_lines.hpp"
#include "reports/document/kinds_of_line.hpp"
#include "reports/document/taken_fields.hpp"

namespace plumb::reports {
namespace {

Json two_points(const Field& field) {
  return {as::numbers<3>(field.element(0, 2, "points")), as::numbers<3>(field.element(1, 2, "points"))};
}

Json ascending(const Field& field) {
  Json out = Json::array();
  for (const Field& value : field.elements()) {
    if (!out.empty() && !(value.number() > out.back().get<double>())) value.fail("must be above the one before it");
    out.push_back(value.number());
  }
  if (out.empty()) field.fail("is empty");
  return out;
}

constexpr std::array kFaults{"signs", "z", "both", "nothing"};
constexpr std::array kSweeps{"ratio", "aspect", "exponent"};
constexpr std::array kSolutions{"signs", "z", "both", "common normal", "common normal, apart"};

void take_group(Json& out, const Field& line) {
  Json group = read_parts(line, {{"group", as::text},
                                 {"shape", as::text},
                                 {"fails", as::one_of<kFaults>},
                                 {"aspect", as::positive},
                                 {"exponents", as::numbers<2>},
                                 {"theta_L_deg", as::number},
                                 {"phi_L_deg", as::number},
                                 {"euler_deg", as::numbers<3>},
                                 {"drawn", as::count}});
  group["answers"] = Json::array();
  out["groups"].push_back(std::move(group));
}

Json& group_of(Json& out, const Field& line) {
  const Field name = line.member("group");
  for (Json& group : out["groups"])
    if (group["group"] == name.text()) return group;
  name.fail("'" + name.text() + "' is of no line before this one");
}

void take_answer(Json& out, const Field& line) {
  group_of(out, line)["answers"].push_back(read_parts(line, {{"ratio", as::number},
                                                             {"method", as::text},
                                                             {"status", as::text},
                                                             {"points", as::or_null<two_points>},
                                                             {"residues", as::or_null<as::numbers<5>>},
                                                             {"angles_deg", as::or_null<as::numbers<3>>},
                                                             {"off_deg", as::or_null<as::number>},
                                                             {"certified", as::flag}}));
}

Json map_rows(const Field& field, std::size_t rows, std::size_t columns) {
  Json out = Json::array();
  for (std::size_t i = 0; i < rows; ++i) {
    const Field row = field.element(i, rows, "rows");
    out.push_back(Json::array());
    for (std::size_t k = 0; k < columns; ++k)
      out.back().push_back(as::or_null<as::number>(row.element(k, columns, "numbers")));
  }
  return out;
}

void take_map(Json& out, const Field& line) {
  Json map = read_parts(line, {{"aspect", as::positive},
                               {"phi_deg", as::number},
                               {"ratio", as::number},
                               {"method", as::text},
                               {"theta_L_deg", ascending},
                               {"theta_deg", ascending},
                               {"not_certified", as::count}});
  map["off_deg"] = map_rows(line.member("off_deg"), map["theta_L_deg"].size(), map["theta_deg"].size());
  out["maps"].push_back(std::move(map));
}

void take_share(Json& out, const Field& line) {
  Json share = read_parts(line, {{"aspect", as::positive},
                                 {"ratio", as::number},
                                 {"method", as::text},
                                 {"pairs", as::count},
                                 {"answers", as::count},
                                 {"off", as::count},
                                 {"low", as::number},
                                 {"high", as::number},
                                 {"median_deg", as::or_null<as::number>}});
  if (share["answers"] > share["pairs"]) line.member("answers").fail("is above pairs");
  if (share["off"] > share["answers"]) line.member("off").fail("is above answers");
  out["shares"].push_back(std::move(share));
}

void take_limit(Json& out, const Field& line) {
  Json limit = read_parts(line, {{"sweep", as::one_of<kSweeps>},
                                 {"shape", as::text},
                                 {"x", as::positive},
                                 {"system", as::text},
                                 {"pairs", as::count},
                                 {"certified", as::count},
                                 {"angle_deg", as::or_null<as::number>},
                                 {"angle_max_deg", as::or_null<as::number>},
                                 {"point", as::or_null<as::number>},
                                 {"overlap", as::or_null<as::number>}});
  if (limit["certified"] > limit["pairs"]) line.member("certified").fail("is above pairs");
  out["limits"].push_back(std::move(limit));
}

void take_order(Json& out, const Field& line) {
  out["orders"].push_back(read_parts(line, {{"shape", as::text},
                                            {"system", as::text},
                                            {"angle", as::or_null<as::number>},
                                            {"point", as::or_null<as::number>},
                                            {"overlap", as::or_null<as::number>},
                                            {"limit_deg", as::or_null<as::number>}}));
}

void take_cost(Json& out, const Field& line) {
  out["costs"].push_back(read_parts(line, {{"set", as::text},
                                           {"method", as::text},
                                           {"target_deg", as::positive},
                                           {"tolerance", as::or_null<as::number>},
                                           {"evaluations", as::or_null<as::number>},
                                           {"share", as::number}}));
}

Json roots(const Field& field) {
  const std::vector<Part> parts{{"kind", as::one_of<kSolutions>},
                                {"normal", as::or_null<as::numbers<3>>},
                                {"distance", as::or_null<as::number>},
                                {"residues", as::or_null<as::numbers<3>>},
                                {"off_deg", as::or_null<as::number>},
                                {"starts", as::count},
                                {"documented", as::flag}};
  Json out = Json::array();
  for (const Field& root : field.elements()) out.push_back(read_parts(root, parts));
  return out;
}

std::int64_t ends_of(const Json& pair) {
  std::int64_t ends = pair["not_converged"].get<std::int64_t>() + pair["elsewhere"].get<std::int64_t>();
  for (const Json& root : pair["roots"]) ends += root["starts"].get<std::int64_t>();
  return ends;
}

void take_roots(Json& out, const Field& line) {
  Json pair = read_parts(line, {{"pair", as::text},
                                {"complete", as::flag},
                                {"reason", as::text},
                                {"starts", as::count},
                                {"not_converged", as::count},
                                {"elsewhere", as::count},
                                {"roots", roots}});
  if (ends_of(pair) > pair["starts"]) line.member("starts").fail("is below the number of their ends");
  out["roots"].push_back(std::move(pair));
}

const std::vector<Kind>& study_kinds() {
  static const std::vector<Kind> all{{"group", {"group"}, take_group},
                                     {"answer", {"group", "ratio", "method"}, take_answer},
                                     {"map", {"aspect", "phi_deg", "ratio", "method"}, take_map},
                                     {"share", {"aspect", "ratio", "method"}, take_share},
                                     {"limit", {"sweep", "shape", "x", "system"}, take_limit},
                                     {"order", {"shape", "system"}, take_order},
                                     {"cost", {"set", "method", "target_deg"}, take_cost},
                                     {"roots", {"pair"}, take_roots}};
  return all;
}

}  // namespace

Json study_json(const std::filesystem::path& file) {
  const Json empty{{"commit", "unknown"},     {"host", nullptr},         {"command", ""},
                   {"interrupted", false},    {"groups", Json::array()}, {"maps", Json::array()},
                   {"shares", Json::array()}, {"limits", Json::array()}, {"orders", Json::array()},
                   {"costs", Json::array()},  {"roots", Json::array()}};
  return read_kinds(file, empty, take_run, study_kinds(), "plumb report-study");
}

}  // namespace plumb::reports
