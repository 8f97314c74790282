#include <optional>

#include "corpus/object_reader.hpp"
#include "reports/campaign/document.hpp"

namespace plumb::reports {
namespace {

Json point_json(const Json& line) {
  return {{"method", line.at("method")},         {"scalar", line.at("scalar")},
          {"tolerance", line.at("tolerance")},   {"certificate", line.at("certificate")},
          {"problem", line.at("problem")},       {"command", line.at("command")},
          {"median_ns", line.at("median_ns")},   {"p99_ns", line.at("p99_ns")},
          {"iterations", line.at("iterations")}, {"failed", line.at("not_converged")},
          {"off", line.at("off_by_0.01_deg")},   {"judged", line.at("judged")},
          {"overlap", line.at("overlap_error")}, {"normal", line.at("normal_error_rad")},
          {"points", line.at("point_error")},    {"pareto", line.at("pareto")}};
}

Json path_json(const Json& line) {
  Json steps = Json::array();
  for (const Json& step : line.at("steps"))
    steps.push_back({{"iterations", step.at("iterations")},
                     {"normal", step.at("normal_error_rad")},
                     {"overlap", step.at("overlap_error")}});
  return {
      {"method", line.at("method")}, {"scalar", line.at("scalar")}, {"command", line.at("command")}, {"steps", steps}};
}

Json set_json(const Json& line) {
  return {{"name", line.at("set")},
          {"of", line.at("of")},
          {"pairs", line.at("pairs")},
          {"envelopes", line.at("envelopes")},
          {"points", Json::array()},
          {"paths", Json::array()},
          {"auto_on_front", line.at("auto_on_front")},
          {"front_note", line.at("front_note")}};
}

/// A set's own line comes before those of its points and paths.
Json& set_of(Json& sets, const Json& line) {
  for (Json& set : sets)
    if (set["name"] == line.at("set")) return set;
  throw FieldError("set", "has no line of its own before this one");
}

void take(Json& out, const Json& line) {
  const std::string kind = line.at("kind");
  if (kind == "run") {
    out["commit"] = line.at("host").at("commit");
    out["command"] = line.at("command");
  } else if (kind == "interrupted") {
    out["without"] = line.at("without");
  } else if (kind == "set") {
    out["sets"].push_back(set_json(line));
  } else if (kind == "point") {
    set_of(out["sets"], line)["points"].push_back(point_json(line));
  } else if (kind == "path") {
    set_of(out["sets"], line)["paths"].push_back(path_json(line));
  } else {
    throw FieldError("kind", "'" + kind + "' is none of run, set, point, path, interrupted");
  }
}

}  // namespace

Json precision_json(const std::filesystem::path& file) {
  Json out{{"commit", "unknown"}, {"command", ""}, {"without", Json::array()}, {"sets", Json::array()}};
  ObjectReader objects(file.string(), ObjectReader::Layout::by_content);
  while (const std::optional<std::string> text = objects.next()) {
    try {
      take(out, read_json(*text));
    } catch (const FieldError& e) {
      throw InputFailure(file.string(), objects.line(), e.field, e.what());
    } catch (const Json::exception& e) {
      throw InputFailure(file.string(), objects.line(), "", e.what());
    }
  }
  if (out["sets"].empty()) throw InputFailure(file.string(), 0, "", "holds no line of plumb report-precision");
  return out;
}

}  // namespace plumb::reports
