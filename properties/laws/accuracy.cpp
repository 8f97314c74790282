#include "properties/laws/accuracy.hpp"

#include <cmath>
#include <sstream>

#include "corpus/case/case.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/json/number_text.hpp"

namespace plumb {
namespace {

[[noreturn]] void refuse(const std::string& part) {
  throw FieldError(part, "is none of normal=ANGLE (1e-6rad, 0.01deg), overlap=RATIO, points=RATIO");
}

double read_number(const std::string& text, const std::string& part) {
  const auto number = number_from<double>(text);
  if (!number || !std::isfinite(*number) || *number < 0) refuse(part);
  return *number;
}

double read_angle(const std::string& text, const std::string& part) {
  constexpr std::size_t unit = 3;  // letters
  if (text.size() <= unit) refuse(part);
  const double number = read_number(text.substr(0, text.size() - unit), part);
  if (text.ends_with("rad")) return number;
  if (text.ends_with("deg")) return number * kRadiansPerDegree;
  refuse(part);
}

void read_part(Accuracy& accuracy, const std::string& part) {
  const std::size_t equals = part.find('=');
  if (equals == std::string::npos) refuse(part);
  const std::string name = part.substr(0, equals), value = part.substr(equals + 1);
  if (name == "normal") {
    accuracy.normal = read_angle(value, part);
  } else if (name == "overlap") {
    accuracy.overlap = read_number(value, part);
  } else if (name == "points") {
    accuracy.points = read_number(value, part);
  } else {
    refuse(part);
  }
}

bool same(const Accuracy& a, const Accuracy& b) {
  return a.normal == b.normal && a.overlap == b.overlap && a.points == b.points;
}

Accuracy read_accuracy(const std::string& text) {
  for (const AccuracyLevel& level : accuracy_levels)
    if (text == level.name) return level.accuracy;
  if (text.empty()) refuse(text);
  Accuracy out;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) read_part(out, part);
  return out;
}

}  // namespace

Accuracy parse_accuracy(const std::string& text) try { return read_accuracy(text); } catch (const FieldError& e) {
  throw InputFailure("--accuracy", 0, e.field, e.what());
}

std::optional<Accuracy> accuracy_instead(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return parse_accuracy(text);
}

Accuracy accuracy_of_case(const Case& c, const std::string& file, int line) {
  if (!c.extra.contains("x_accuracy")) return {};
  const Field kept = Field(c.extra).member("x_accuracy");
  try {
    return read_accuracy(kept.text());
  } catch (const FieldError& e) {
    throw InputFailure(file, line, "x_accuracy",
                       e.field == "x_accuracy" ? e.what() : "'" + kept.text() + "' " + e.what());
  }
}

std::string accuracy_text(const Accuracy& accuracy) {
  for (const AccuracyLevel& level : accuracy_levels)
    if (same(accuracy, level.accuracy)) return std::string(level.name);
  std::string out = "normal=" + shortest(accuracy.normal) + "rad,overlap=" + shortest(accuracy.overlap);
  if (accuracy.points) out += ",points=" + shortest(*accuracy.points);
  return out;
}

}  // namespace plumb
