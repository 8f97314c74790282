#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "corpus/case.hpp"
#include "reports/campaign/document.hpp"
#include "reports/campaign/lines.hpp"

namespace plumb::reports {
namespace {

using Read = Json (*)(const Field&);

/// A field as the document takes it over.
struct Part {
  const char* name;
  Read read;
};
using Parts = std::vector<Part>;

Json text(const Field& field) {
  return field.text();
}

Json number(const Field& field) {
  return field.number();
}

/// It lies on a logarithmic axis.
Json positive(const Field& field) {
  if (!(field.number() > 0)) field.fail("must be above 0");
  return field.number();
}

Json count(const Field& field) {
  return field.count();
}

Json flag(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value();
}

template <std::size_t N>
Json numbers(const Field& field) {
  return field.numbers<N>();
}

template <Read read>
Json or_null(const Field& field) {
  return field.value().is_null() ? Json() : read(field);
}

Json two_points(const Field& field) {
  return {numbers<3>(field.element(0, 2, "points")), numbers<3>(field.element(1, 2, "points"))};
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

template <const auto& words>
Json one_of(const Field& field) {
  std::string known;
  for (const char* word : words) {
    if (field.text() == word) return word;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  field.fail("'" + field.text() + "' is none of " + known);
}

constexpr std::array kFaults{"signs", "z", "both", "nothing"};
constexpr std::array kSweeps{"ratio", "aspect", "exponent"};
constexpr std::array kSolutions{"signs", "z", "both", "common normal", "common normal, apart"};

Json read(const Field& object, const Parts& parts) {
  Json out = Json::object();
  for (const auto& [name, read] : parts) out[name] = read(object.member(name));
  return out;
}

void take_group(Json& out, const Field& line) {
  Json group = read(line, {{"group", text},
                           {"shape", text},
                           {"fails", one_of<kFaults>},
                           {"aspect", positive},
                           {"exponents", numbers<2>},
                           {"theta_L_deg", number},
                           {"phi_L_deg", number},
                           {"euler_deg", numbers<3>},
                           {"drawn", count}});
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
  group_of(out, line)["answers"].push_back(read(line, {{"ratio", number},
                                                       {"method", text},
                                                       {"status", text},
                                                       {"points", or_null<two_points>},
                                                       {"residues", or_null<numbers<5>>},
                                                       {"angles_deg", or_null<numbers<3>>},
                                                       {"off_deg", or_null<number>},
                                                       {"certified", flag}}));
}

Json map_rows(const Field& field, std::size_t rows, std::size_t columns) {
  Json out = Json::array();
  for (std::size_t i = 0; i < rows; ++i) {
    const Field row = field.element(i, rows, "rows");
    out.push_back(Json::array());
    for (std::size_t k = 0; k < columns; ++k) out.back().push_back(or_null<number>(row.element(k, columns, "numbers")));
  }
  return out;
}

void take_map(Json& out, const Field& line) {
  Json map = read(line, {{"aspect", positive},
                         {"phi_deg", number},
                         {"ratio", number},
                         {"method", text},
                         {"theta_L_deg", ascending},
                         {"theta_deg", ascending},
                         {"not_certified", count}});
  map["off_deg"] = map_rows(line.member("off_deg"), map["theta_L_deg"].size(), map["theta_deg"].size());
  out["maps"].push_back(std::move(map));
}

void take_share(Json& out, const Field& line) {
  Json share = read(line, {{"aspect", positive},
                           {"ratio", number},
                           {"method", text},
                           {"pairs", count},
                           {"answers", count},
                           {"off", count},
                           {"low", number},
                           {"high", number},
                           {"median_deg", or_null<number>}});
  if (share["answers"] > share["pairs"]) line.member("answers").fail("is above pairs");
  if (share["off"] > share["answers"]) line.member("off").fail("is above answers");
  out["shares"].push_back(std::move(share));
}

void take_limit(Json& out, const Field& line) {
  Json limit = read(line, {{"sweep", one_of<kSweeps>},
                           {"shape", text},
                           {"x", positive},
                           {"system", text},
                           {"pairs", count},
                           {"certified", count},
                           {"angle_deg", or_null<number>},
                           {"angle_max_deg", or_null<number>},
                           {"point", or_null<number>},
                           {"overlap", or_null<number>}});
  if (limit["certified"] > limit["pairs"]) line.member("certified").fail("is above pairs");
  out["limits"].push_back(std::move(limit));
}

void take_order(Json& out, const Field& line) {
  out["orders"].push_back(read(line, {{"shape", text},
                                      {"system", text},
                                      {"angle", or_null<number>},
                                      {"point", or_null<number>},
                                      {"overlap", or_null<number>},
                                      {"limit_deg", or_null<number>}}));
}

void take_cost(Json& out, const Field& line) {
  out["costs"].push_back(read(line, {{"set", text},
                                     {"method", text},
                                     {"target_deg", positive},
                                     {"tolerance", or_null<number>},
                                     {"evaluations", or_null<number>},
                                     {"share", number}}));
}

Json roots(const Field& field) {
  const Parts parts{{"kind", one_of<kSolutions>},  {"normal", or_null<numbers<3>>},
                    {"distance", or_null<number>}, {"residues", or_null<numbers<3>>},
                    {"off_deg", or_null<number>},  {"starts", count},
                    {"documented", flag}};
  Json out = Json::array();
  for (const Field& root : field.elements()) out.push_back(read(root, parts));
  return out;
}

std::int64_t ends_of(const Json& pair) {
  std::int64_t ends = pair["not_converged"].get<std::int64_t>() + pair["elsewhere"].get<std::int64_t>();
  for (const Json& root : pair["roots"]) ends += root["starts"].get<std::int64_t>();
  return ends;
}

void take_roots(Json& out, const Field& line) {
  Json pair = read(line, {{"pair", text},
                          {"complete", flag},
                          {"reason", text},
                          {"starts", count},
                          {"not_converged", count},
                          {"elsewhere", count},
                          {"roots", roots}});
  if (ends_of(pair) > pair["starts"]) line.member("starts").fail("is below the number of their ends");
  out["roots"].push_back(std::move(pair));
}

/// Lines of one kind: what tells them apart, and who takes them.
struct Kind {
  const char* name;
  std::vector<const char*> key;
  void (*take)(Json& out, const Field& line);
};

const std::vector<Kind>& kinds() {
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

class StudyReader {
 public:
  /// The first line is of kind run, and nothing follows one of kind interrupted.
  void take(const Field& line) {
    const Field kind = line.member("kind");
    const std::string word = kind.text();
    if (out_["interrupted"] == true) kind.fail("comes after the line of kind interrupted");
    if ((word == "run") != out_["host"].is_null())
      kind.fail(word == "run" ? "'run' is there twice" : "'" + word + "' comes before the line of kind run");
    if (word == "run")
      take_run(out_, line);
    else if (word == "interrupted")
      out_["interrupted"] = true;
    else
      take_kind(kind, line);
  }

  [[nodiscard]] bool is_empty() const { return known_.empty(); }
  [[nodiscard]] const Json& document() const { return out_; }

 private:
  void take_kind(const Field& kind, const Field& line) {
    std::string names = "run";
    for (const Kind& known : kinds()) {
      if (kind.text() == known.name) {
        known.take(out_, line);
        return refuse_twice(known, line);
      }
      names += ", " + std::string(known.name);
    }
    kind.fail("'" + kind.text() + "' is none of " + names + ", interrupted");
  }

  /// 2 and 2.0 are one number.
  static Json comparable(const Json& value) { return value.is_number() ? Json(value.get<double>()) : value; }

  void refuse_twice(const Kind& kind, const Field& line) {
    std::string values = kind.name;
    for (const char* field : kind.key) values += " " + comparable(line.member(field).value()).dump();
    if (known_.insert(values).second) return;
    std::string others;
    for (std::size_t i = 0; i + 1 < kind.key.size(); ++i)
      others += (i == 0 ? ", of " : " and ") + std::string(kind.key[i]);
    line.member(kind.key.back()).fail("is there twice" + others);
  }

  Json out_{{"commit", "unknown"},     {"host", nullptr},        {"command", ""},           {"interrupted", false},
            {"groups", Json::array()}, {"maps", Json::array()},  {"shares", Json::array()}, {"limits", Json::array()},
            {"orders", Json::array()}, {"costs", Json::array()}, {"roots", Json::array()}};
  std::set<std::string> known_;
};

}  // namespace

Json study_json(const std::filesystem::path& file) {
  StudyReader reader;
  for_each_line(file, [&](const Field& line) { reader.take(line); });
  if (reader.is_empty()) throw InputFailure(file.string(), 0, "", "holds no result of plumb report-study");
  return reader.document();
}

}  // namespace plumb::reports
