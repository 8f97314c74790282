#include <algorithm>
#include <cstdint>
#include <vector>

#include "corpus/case/case.hpp"
#include "reports/document/document.hpp"
#include "reports/document/json_lines.hpp"

namespace plumb::reports {
namespace {

constexpr std::array kCounted{"cases", "right", "lost", "wrong"};

/// The knob and its steps; a row of the same ladder has the same.
Json ladder_of(const Field& line) {
  Json steps = Json::array();
  for (const Field& step : line.member("steps").elements()) steps.push_back(step.number());
  if (steps.empty()) line.member("steps").fail("is empty");
  return {{"name", line.member("ladder").text()}, {"knob", line.member("knob").text()}, {"steps", steps}};
}

void refuse_another_ladder(const Json& known, const Json& ladder, const Field& line) {
  for (const char* field : {"knob", "steps"})
    if (known[field] != ladder[field])
      line.member(field).fail("is " + ladder[field].dump() + ", in a line before this one " + known[field].dump());
}

Json& take_ladder(Json& ladders, const Field& line) {
  const Json ladder = ladder_of(line);
  for (Json& known : ladders)
    if (known["name"] == ladder["name"]) {
      refuse_another_ladder(known, ladder, line);
      return known;
    }
  ladders.push_back(ladder);
  ladders.back()["rows"] = Json::array();
  return ladders.back();
}

std::vector<int> step_numbers(const Field& field, std::size_t steps) {
  std::vector<int> out;
  for (std::size_t i = 0; i < steps; ++i) out.push_back(field.element(i, steps, "counts").count());
  return out;
}

void refuse_bad_sums(const Json& row, const Field& line) {
  for (std::size_t i = 0; i < row["cases"].size(); ++i) {
    const auto at = [&](const char* field) { return row[field][i].get<std::int64_t>(); };
    if (at("right") + at("lost") + at("wrong") > at("cases"))
      line.member("cases").fail("step " + std::to_string(i + 1) + " has more answers than cases");
  }
}

Json digits_json(const Field& digits) {
  Json out = Json::object();
  for (const char* name : {"overlap", "normal", "points"}) {
    const Field figure = digits.member(name);
    out[name] = figure.value().is_null() ? Json() : Json(figure.number());
  }
  return out;
}

Json let_go_step(const Field& field, std::size_t steps) {
  return field.value().is_null() ? Json() : Json(field.whole_number(1, static_cast<int>(steps)));
}

Json stability_row(const Field& line, std::size_t steps) {
  Json row{{"method", line.member("method").text()}, {"arithmetic", line.member("arithmetic").text()}};
  for (const char* counts : kCounted) row[counts] = step_numbers(line.member(counts), steps);
  refuse_bad_sums(row, line);
  row["digits"] = digits_json(line.member("digits"));
  row["lets_go"] = let_go_step(line.member("lets_go"), steps);
  return row;
}

bool is_same(const Json& one, const Json& other) {
  return one["method"] == other["method"] && one["arithmetic"] == other["arithmetic"];
}

Json* find_row(Json& rows, const Json& row) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Json& known) { return is_same(known, row); });
  return found == rows.end() ? nullptr : &*found;
}

void take_row(Json& out, const Field& line) {
  Json& ladder = take_ladder(out["ladders"], line);
  Json row = stability_row(line, ladder["steps"].size());
  if (find_row(ladder["rows"], row) != nullptr) line.member("arithmetic").fail("is there twice, of ladder and method");
  ladder["rows"].push_back(std::move(row));
}

/// The first line is of kind run, and nothing follows one of kind interrupted.
void take_stability(Json& out, const Field& line) {
  const Field kind = line.member("kind");
  const std::string word = kind.text();
  if (out["interrupted"] == true) kind.fail("comes after the line of kind interrupted");
  if ((word == "run") != out["host"].is_null())
    kind.fail(word == "run" ? "'run' is there twice" : "'" + word + "' comes before the line of kind run");
  if (word == "run")
    take_run(out, line);
  else if (word == "row")
    take_row(out, line);
  else if (word == "interrupted")
    out["interrupted"] = true;
  else
    kind.fail("'" + word + "' is none of run, row, interrupted");
}

std::int64_t sum_of_steps(const Json& counts) {
  std::int64_t sum = 0;
  for (const Json& n : counts) sum += n.get<std::int64_t>();
  return sum;
}

void add_to_total(Json& totals, const Json& row) {
  if (find_row(totals, row) == nullptr) {
    totals.push_back({{"method", row["method"]}, {"arithmetic", row["arithmetic"]}});
    for (const char* counts : kCounted) totals.back()[counts] = 0;
  }
  Json& total = *find_row(totals, row);
  for (const char* counts : kCounted) total[counts] = total[counts].get<std::int64_t>() + sum_of_steps(row[counts]);
}

/// Over all ladders, by method and arithmetic.
Json totals_json(const Json& ladders) {
  Json totals = Json::array();
  for (const Json& ladder : ladders)
    for (const Json& row : ladder["rows"]) add_to_total(totals, row);
  return totals;
}

}  // namespace

Json stability_json(const std::filesystem::path& file) {
  Json out{
      {"commit", "unknown"}, {"host", nullptr}, {"command", ""}, {"interrupted", false}, {"ladders", Json::array()}};
  for_each_line(file, [&](const Field& line) { take_stability(out, line); });
  if (out["ladders"].empty()) throw InputFailure(file.string(), 0, "", "holds no row of plumb report-stability");
  out["totals"] = totals_json(out["ladders"]);
  return out;
}

}  // namespace plumb::reports
