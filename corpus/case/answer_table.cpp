#include "corpus/case/answer_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

std::string number_text(const Json& number) {
  return number.is_string() ? number.get<std::string>() : fmt::format("{:.3e}", number.get<double>());
}

std::string vector_text(const Json& v) {
  return fmt::format("{: .10e}  {: .10e}  {: .10e}", v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

void add_row(std::string& out, std::string_view label, const std::string& text) {
  out += fmt::format("  {:<12} {}\n", label, text);
}

void add_vector(std::string& out, std::string_view label, const Json& fields, const char* key) {
  if (fields.contains(key)) add_row(out, label, vector_text(fields[key]));
}

void add_points(std::string& out, const Json& fields) {
  if (!fields.contains("points")) return;
  add_row(out, "point 1", vector_text(fields["points"][0]));
  add_row(out, "point 2", vector_text(fields["points"][1]));
}

/// "d_n1 1.2e-15  d_n2 ..."
void add_group(std::string& out, std::string_view label, const Json& fields, const char* key, std::string_view unit) {
  if (!fields.contains(key)) return;
  std::string text;
  for (const auto& [name, value] : fields[key].items())
    text += fmt::format("{}{} {:.1e}", text.empty() ? "" : "  ", name, value.get<double>());
  add_row(out, label, text + std::string(unit));
}

void add_curvature(std::string& out, const Json& fields) {
  if (!fields.contains("curvature")) return;
  for (int i = 0; i < 2; ++i) {
    const Json& curvature = fields["curvature"][static_cast<std::size_t>(i)];
    if (!curvature.contains("radii")) continue;
    add_row(out, fmt::format("radii {}", i + 1),
            number_text(curvature["radii"][0]) + ", " + number_text(curvature["radii"][1]) +
                " (principal, of curvature)");
  }
}

void add_derivatives(std::string& out, const Json& fields) {
  if (!fields.contains("derivatives")) return;
  for (int i = 0; i < 2; ++i) {
    const Json& of_body = fields["derivatives"][static_cast<std::size_t>(i)];
    add_vector(out, fmt::format("do/dx{}", i + 1), of_body, "overlap_by_shift");
    add_vector(out, fmt::format("do/dw{}", i + 1), of_body, "overlap_by_turn");
    for (const auto& [label, key] : {std::pair{"dn/dx", "normal_by_shift"}, {"dn/dw", "normal_by_turn"}})
      for (const Json& row : of_body.value(key, Json::array()))
        add_row(out, fmt::format("{}{}", label, i + 1), vector_text(row));
  }
}

void add_patch(std::string& out, const Json& fields) {
  if (!fields.contains("patch")) return;
  const Json& patch = fields["patch"];
  add_row(out, "patch",
          fmt::format("volume {:.6e}, area {:.6e}, error {:.1e}", patch["volume"].get<double>(),
                      patch["area"].get<double>(), patch["error"].get<double>()));
  add_vector(out, "  normal", patch, "normal");
  add_vector(out, "  centre", patch, "centre");
  add_vector(out, "  moments", patch, "second_moments");
}

std::string effort_text(const Json& fields) {
  return fmt::format("{} iterations, {} evaluations, {}", fields["iterations"].get<int>(),
                     fields["evaluations"].get<int>(), time_text(fields["timing"]["ns"].get<double>()));
}

std::string one_answer(const Answer& answer) {
  const Json fields = answer_json(answer);
  std::string out;
  add_row(out, "method", fields["method"]);
  if (answer.none) {
    add_row(out, answer.none->finding, answer.none->detail);
    return out;
  }
  add_row(out, "status",
          fmt::format("{}, {}", fields["status"].get<std::string>(), fields["verdict"].get<std::string>()));
  if (fields.contains("overlap")) add_row(out, "overlap", fmt::format("{: .16e}", fields["overlap"].get<double>()));
  add_vector(out, "normal", fields, "normal");
  add_points(out, fields);
  add_vector(out, "contact", fields, "contact_point");
  add_group(out, "angles", fields, "angles_deg", "  deg");
  add_group(out, "residues", fields, "residuals", "");
  add_curvature(out, fields);
  add_derivatives(out, fields);
  add_patch(out, fields);
  add_row(out, "effort", effort_text(fields));
  return out;
}

std::string largest_angle(const Json& fields) {
  if (!fields.contains("angles_deg")) return "-";
  double largest = 0;
  for (const Json& angle : fields["angles_deg"]) largest = std::max(largest, angle.get<double>());
  return fmt::format("{:.1e}", largest);
}

std::string row(const Answer& answer) {
  if (answer.none)
    return fmt::format("  {:<26} {}: {}\n", answer.contact.method, answer.none->finding, answer.none->detail);
  const Json fields = answer_json(answer);
  const std::string overlap =
      fields.contains("overlap") ? fmt::format("{: .5e}", fields["overlap"].get<double>()) : "-";
  return fmt::format("  {:<26} {:<15} {:>13}{:>9}{:>4}{:>9}\n", fields["method"].get<std::string>(),
                     fields["status"].get<std::string>(), overlap, largest_angle(fields), answer.contact.iterations,
                     answer.nanoseconds ? time_text(*answer.nanoseconds) : "-");
}

}  // namespace

std::string time_text(double nanoseconds) {
  if (nanoseconds < 1e3) return fmt::format("{:.0f} ns", nanoseconds);
  if (nanoseconds < 1e6) return fmt::format("{:.1f} us", nanoseconds / 1e3);
  return nanoseconds < 1e9 ? fmt::format("{:.1f} ms", nanoseconds / 1e6) : fmt::format("{:.1f} s", nanoseconds / 1e9);
}

std::string answer_table(const std::vector<Answer>& answers) {
  std::string out = answers.front().name + "\n";
  if (answers.size() == 1) return out + one_answer(answers.front());
  // The angle is the largest of the answer's own three: 0 for a true common normal.
  out += fmt::format("  {:<26} {:<15} {:>13}{:>9}{:>4}{:>9}\n", "method", "status", "overlap", "deg off", "it", "time");
  for (const Answer& answer : answers) out += row(answer);
  return out;
}

}  // namespace plumb
