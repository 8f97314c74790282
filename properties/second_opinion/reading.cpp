#include "reading.hpp"

#include <array>

namespace second_opinion {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& field, const std::string& reason) {
  throw Unusable(field + ": " + reason);
}

const Json& required(const Json& object, const std::string& field, const std::string& path) {
  if (!object.is_object() || !object.contains(field)) refuse(path + field, "is missing");
  return object.at(field);
}

template <std::size_t N>
std::array<double, N> numbers(const Json& from, const std::string& path) {
  if (!from.is_array() || from.size() != N) refuse(path, "must be " + std::to_string(N) + " numbers");
  std::array<double, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!from[i].is_number()) refuse(path, "must be " + std::to_string(N) + " numbers");
    out[i] = from[i].get<double>();
  }
  return out;
}

Vec<double> vector(const Json& from, const std::string& path) {
  const auto [x, y, z] = numbers<3>(from, path);
  return {x, y, z};
}

GivenBody read_body(const Json& from, const std::string& path) {
  const Json& shape = required(required(from, "shape", path), "superellipsoid", path + "shape.");
  GivenBody out;
  out.axes = vector(required(shape, "semi_axes", path), path + "semi_axes");
  if (!(std::min(out.axes.x, std::min(out.axes.y, out.axes.z)) > 0)) refuse(path + "semi_axes", "must be above 0");
  if (shape.contains("exponents")) {
    const auto [n1, n2] = numbers<2>(shape["exponents"], path + "exponents");
    if (!(n1 > 1 && n2 > 1)) refuse(path + "exponents", "must be above 1");
    out.n1 = n1;
    out.n2 = n2;
  }
  out.position = vector(required(from, "position", path), path + "position");
  const Json& turned = required(required(from, "orientation", path), "quaternion_wxyz", path + "orientation.");
  out.quaternion = numbers<4>(turned, path + "quaternion_wxyz");
  if (out.quaternion == std::array<double, 4>{}) refuse(path + "quaternion_wxyz", "must not be 0");
  return out;
}

/// Only whole ones: a field with a null or a word in it is none.
std::optional<Vec<double>> read_vector(const Json& from) {
  if (!from.is_array() || from.size() != 3) return std::nullopt;
  for (const Json& x : from)
    if (!x.is_number()) return std::nullopt;
  return vector(from, "");
}

Answer read_answer(const Json& from) {
  if (!from.is_object()) refuse("answer", "must be an object");
  Answer out;
  out.status = from.value("status", "converged");
  if (from.contains("overlap") && from["overlap"].is_number()) out.overlap = from["overlap"].get<double>();
  out.verdict = from.value("verdict", !out.overlap ? "undecided" : *out.overlap > 0 ? "overlapping" : "separated");
  if (from.contains("normal")) out.normal = read_vector(from["normal"]);
  if (from.contains("points") && from["points"].is_array() && from["points"].size() == 2) {
    out.point1 = read_vector(from["points"][0]);
    out.point2 = read_vector(from["points"][1]);
  }
  if (from.contains("contact_point")) out.contact_point = read_vector(from["contact_point"]);
  out.evaluations = from.value("evaluations", 0);
  return out;
}

void leave_out_unclaimed(Claim& out, const Json& abilities) {
  const std::string points = abilities.value("points", "two");
  out.is_bare = abilities.value("apart", "distance") == "verdict" && out.answer.verdict == "separated";
  if (!abilities.value("normal", true)) out.answer.normal.reset();
  if (points != "two") out.answer.point1.reset(), out.answer.point2.reset();
  if (points == "none") out.answer.contact_point.reset();
}

void read_problem(Claim& out, const std::string& word) {
  if (word == "deepest_points") out.problem = Problem::deepest_points;
  if (word == "midway") out.problem = Problem::midway;
  out.is_known_problem = word == "common_normal" || out.problem != Problem::common_normal;
}

/// Whether the bodies overlap is a question about the pair: the common normal's, whatever problem the answer is of.
bool is_about_the_verdict(const std::string& finding) {
  return finding == "missed_contact" || finding == "false_contact";
}

Claim read(const Json& from) {
  const Json& bodies = required(from, "bodies", "");
  if (!bodies.is_array() || bodies.size() != 2) refuse("bodies", "must be two");
  Claim out;
  out.pair = {read_body(bodies[0], "bodies[0]."), read_body(bodies[1], "bodies[1].")};
  out.answer = read_answer(required(from, "answer", ""));
  out.finding = required(from, "finding", "").get<std::string>();
  read_problem(out, is_about_the_verdict(out.finding) ? "common_normal" : from.value("problem", "common_normal"));
  const Json accuracy = from.value("accuracy", Json::object());
  out.accuracy = {accuracy.value("normal", 0.0), accuracy.value("overlap", 0.0), accuracy.value("points", 0.0)};
  leave_out_unclaimed(out, from.value("abilities", Json::object()));
  return out;
}

}  // namespace

Claim read_claim(const std::string& line) try { return read(Json::parse(line)); } catch (const Json::exception& e) {
  throw Unusable(std::string("line: ") + e.what());
}

}  // namespace second_opinion
