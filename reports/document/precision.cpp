#include "corpus/case/case.hpp"
#include "reports/document/document.hpp"
#include "reports/document/json_lines.hpp"

namespace plumb::reports {
namespace {

double not_negative(const Field& field) {
  const double x = field.number();
  if (x < 0) field.fail("is below 0");
  return x;
}

double share(const Field& field) {
  const double x = not_negative(field);
  if (x > 1) field.fail("is no share of 1");
  return x;
}

/// null where there is no finite number.
Json number_or_null(const Field& field) {
  return field.value().is_null() ? Json() : Json(not_negative(field));
}

Json quantiles(const Field& field) {
  Json out = Json::object();
  for (const char* name : {"median", "p99", "max"}) out[name] = number_or_null(field.member(name));
  return out;
}

bool truth(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value().get<bool>();
}

Json point_json(const Field& line) {
  const Field iterations = line.member("iterations");
  return {{"method", line.member("method").text()},
          {"scalar", line.member("scalar").text()},
          {"tolerance", not_negative(line.member("tolerance"))},
          {"certificate", line.member("certificate").text()},
          {"problem", line.member("problem").text()},
          {"command", line.member("command").text()},
          {"median_ns", not_negative(line.member("median_ns"))},
          {"p99_ns", not_negative(line.member("p99_ns"))},
          {"iterations",
           {{"median", not_negative(iterations.member("median"))}, {"max", not_negative(iterations.member("max"))}}},
          {"failed", share(line.member("not_converged"))},
          {"off", number_or_null(line.member("off_by_0.01_deg"))},
          {"judged", line.member("judged").count()},
          {"overlap", quantiles(line.member("overlap_error"))},
          {"normal", quantiles(line.member("normal_error_rad"))},
          {"points", quantiles(line.member("point_error"))},
          {"pareto", truth(line.member("pareto"))}};
}

Json path_json(const Field& line) {
  Json steps = Json::array();
  for (const Field& step : line.member("steps").elements())
    steps.push_back({{"iterations", step.member("iterations").count()},
                     {"normal", quantiles(step.member("normal_error_rad"))},
                     {"overlap", quantiles(step.member("overlap_error"))}});
  return {{"method", line.member("method").text()},
          {"scalar", line.member("scalar").text()},
          {"command", line.member("command").text()},
          {"steps", steps}};
}

Json envelopes_json(const Field& field) {
  Json out = Json::array();
  for (const Field& e : field.elements())
    out.push_back({{"scalar", e.member("scalar").text()},
                   {"normal", quantiles(e.member("normal"))},
                   {"overlap", quantiles(e.member("overlap"))},
                   {"points", quantiles(e.member("points"))}});
  return out;
}

Json set_json(const Field& line) {
  return {{"name", line.member("set").text()},
          {"of", line.member("of").text()},
          {"pairs", line.member("pairs").count()},
          {"envelopes", envelopes_json(line.member("envelopes"))},
          {"points", Json::array()},
          {"paths", Json::array()},
          {"auto_on_front", truth(line.member("auto_on_front"))},
          {"front_note", line.member("front_note").text()}};
}

Json* find_set(Json& sets, const std::string& name) {
  for (Json& set : sets)
    if (set["name"] == name) return &set;
  return nullptr;
}

/// A set's own line comes before those of its points and paths.
Json& set_of(Json& sets, const Field& line) {
  Json* set = find_set(sets, line.member("set").text());
  if (set == nullptr) line.member("set").fail("has no line of its own before this one");
  return *set;
}

void take(Json& out, const Field& line) {
  const std::string kind = line.member("kind").text();
  if (kind == "run") {
    take_run(out, line);
  } else if (kind == "interrupted") {
    for (const Field& name : line.member("without").elements()) out["without"].push_back(name.text());
  } else if (kind == "set") {
    if (find_set(out["sets"], line.member("set").text()) != nullptr) line.member("set").fail("is there twice");
    out["sets"].push_back(set_json(line));
  } else if (kind == "point") {
    set_of(out["sets"], line)["points"].push_back(point_json(line));
  } else if (kind == "path") {
    set_of(out["sets"], line)["paths"].push_back(path_json(line));
  } else {
    line.member("kind").fail("'" + kind + "' is none of run, set, point, path, interrupted");
  }
}

}  // namespace

Json precision_json(const std::filesystem::path& file) {
  Json out{
      {"commit", "unknown"}, {"host", nullptr}, {"command", ""}, {"without", Json::array()}, {"sets", Json::array()}};
  for_each_line(file, [&](const Field& line) { take(out, line); });
  if (out["sets"].empty()) throw InputFailure(file.string(), 0, "", "holds no set of plumb report-precision");
  return out;
}

}  // namespace plumb::reports
