#include "corpus/case/answer.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "corpus/case/contract_words.hpp"
#include "corpus/json/fields.hpp"
#include "solver/diagnosis.hpp"
#include "solver/method/methods.hpp"
#include "solver/patch/patch.hpp"

namespace plumb {
namespace {

void put(Json& out, const char* key, double value) {
  if (std::isfinite(value)) out[key] = value;
}

void put(Json& out, const char* key, const Vec3<double>& value) {
  if (value.allFinite()) out[key] = vector_json(value);
}

void put(Json& out, const char* key, const Vec3<double>& first, const Vec3<double>& second) {
  if (first.allFinite() && second.allFinite()) out[key] = {vector_json(first), vector_json(second)};
}

void put_object(Json& out, const char* key, const Json& object) {
  if (!object.empty()) out[key] = object;
}

Json residues_json(const Pair& pair, const Contact<double>& contact) {
  constexpr std::array<const char*, 5> names{"R1", "R2", "R3", "R4", "R5"};
  // The residues are those of the overlapping sense, whatever the sign.
  const Diagnosis diagnosis = diagnose(pair, contact.point1, contact.point2, 1);
  Json out;
  for (std::size_t i = 0; i < 5; ++i) put(out, names[i], diagnosis.residues[i]);
  return out;
}

Json radius_json(double radius) {
  return std::isinf(radius) ? Json("infinite") : Json(radius);
}

Json curvature_json(const PrincipalCurvature<double>& curvature) {
  Json out = Json::object();
  if (std::isnan(curvature.radius1) || std::isnan(curvature.radius2)) return out;
  out["radii"] = {radius_json(curvature.radius1), radius_json(curvature.radius2)};
  put(out, "directions", curvature.direction1, curvature.direction2);
  return out;
}

void put_curvature(Json& out, const Contact<double>& contact) {
  const Json first = curvature_json(contact.curvature[0]), second = curvature_json(contact.curvature[1]);
  if (!first.empty() || !second.empty()) out["curvature"] = {first, second};
}

void put(Json& out, const char* key, const Mat3<double>& m) {
  if (m.allFinite()) out[key] = {vector_json(m.row(0)), vector_json(m.row(1)), vector_json(m.row(2))};
}

/// Of body 1 and body 2; matrices by rows.
void put_derivatives(Json& out, const Contact<double>& contact) {
  if (!contact.derivatives) return;
  Json bodies = Json::array();
  for (const PoseDerivative<double>& d : *contact.derivatives) {
    Json body = Json::object();
    put(body, "overlap_by_shift", d.overlap_by_shift);
    put(body, "overlap_by_turn", d.overlap_by_turn);
    put(body, "normal_by_shift", d.normal_by_shift);
    put(body, "normal_by_turn", d.normal_by_turn);
    bodies.push_back(body);
  }
  out["derivatives"] = bodies;
}

/// Axes by rows.
void put_patch(Json& out, const Contact<double>& contact) {
  if (!contact.patch || !std::isfinite(contact.patch->error)) return;
  const Patch& from = *contact.patch;
  Json patch = Json::object();
  patch["volume"] = from.volume;
  patch["area"] = from.area;
  put(patch, "normal", from.normal);
  put(patch, "centre", from.centre);
  put(patch, "area_moment", from.area_moment);
  put(patch, "second_moments", from.second_moments);
  put(patch, "axes", Mat3<double>(from.axes.transpose()));
  if (from.centre.allFinite()) {
    patch["points"] = Json::array();
    for (const Vec3<double>& point : points_of(from)) patch["points"].push_back(vector_json(point));
  }
  patch["error"] = from.error;
  out["patch"] = patch;
}

std::optional<Field> given(const Field& answer, std::string_view key) {
  const auto field = answer.find(key);
  return field && field->value().is_null() ? std::nullopt : field;
}

Verdict verdict_of(double overlap) {
  const int sign = sign_of(overlap);
  if (sign == 0) return Verdict::undecided;
  return sign > 0 ? Verdict::overlapping : Verdict::separated;
}

void read_geometry(Contact<double>& contact, const Field& answer) {
  if (const auto overlap = given(answer, "overlap")) contact.overlap = overlap->number();
  if (const auto normal = given(answer, "normal")) contact.normal = normal->vector();
  if (const auto points = given(answer, "points")) {
    contact.point1 = points->element(0, 2, "points").vector();
    contact.point2 = points->element(1, 2, "points").vector();
  }
  if (const auto point = given(answer, "contact_point")) contact.contact_point = point->vector();
}

/// A case file in the answer's place, or an object of other names, says nothing that could be wrong.
void require_something_to_judge(const Field& answer) {
  if (!answer.value().is_object()) answer.fail("must be an object with the fields of plumb solve");
  for (const char* field : {"status", "verdict", "overlap", "normal", "points"})
    if (given(answer, field)) return;
  throw FieldError("status, verdict, overlap, normal, points", "all missing, so there is nothing to judge");
}

/// What answer_json writes.
void require_known_fields(const Field& answer) {
  answer.require_object({"name", "method", "status", "verdict", "overlap", "normal", "points", "contact_point",
                         "iterations", "evaluations", "angles_deg", "residuals", "curvature", "derivatives", "patch",
                         "timing"});
}

/// Names of solvers that need not be here: a library (--solver), a peer, the recorder's answers, and those of no name. They are
/// judged as common-normal solvers where "x_problem" does not say otherwise.
bool names_a_foreign_solver(const std::string& name) {
  return name == "answer" || name == "recorded" || name.starts_with("solver:") || name.starts_with("peer_");
}

Problem read_problem(const Field& method) {
  const std::string said = method.text();
  if (const Method* known = find_method(said)) return known->problem;
  std::string words;
  for (const Problem problem : problems) {
    if (said == name(problem)) return problem;
    words += std::string(name(problem)) + ", ";
  }
  if (names_a_foreign_solver(said)) return Problem::common_normal;
  method.fail("must be one of the problems " + words + "a method's name (plumb methods) or \"solver:NAME\", not '" +
              said + "'");
}

GivenAnswer read_answer(const Field& answer) {
  GivenAnswer out{"", "answer", Problem::common_normal, read_contact(answer)};
  require_known_fields(answer);
  if (const auto name = given(answer, "name")) out.name = name->text();
  if (const auto method = given(answer, "method")) {
    out.method = method->text();
    out.problem = read_problem(*method);
    if (const auto problem = given(answer, "x_problem")) out.problem = read_problem(*problem);
  }
  return out;
}

}  // namespace

namespace {

RecordedAnswer read_recorded(const Field& answer) {
  const auto finding = given(answer, "x_finding");
  if (!finding) return {read_answer(answer)};
  require_word(*finding, std::array<std::string_view, 2>{"crash", "slow"});
  const auto detail = given(answer, "x_detail");
  return {{"", "answer", Problem::common_normal, {}}, Answer::None{finding->text(), detail ? detail->text() : ""}};
}

}  // namespace

std::optional<RecordedAnswer> recorded_answer(const Case& c, const std::string& file, int line) {
  const auto answer = c.extra.is_null() ? std::nullopt : Field(c.extra).find("x_answer");
  if (!answer) return std::nullopt;
  try {
    RecordedAnswer out = read_recorded(*answer);
    if (out.given.method == "answer") out.given.method = "recorded";
    return out;
  } catch (const FieldError& error) {
    throw InputFailure(file, line, error.field, error.what());
  }
}

Contact<double> read_contact(const Field& answer) {
  require_something_to_judge(answer);
  Contact<double> out;
  read_geometry(out, answer);
  const auto status = given(answer, "status"), verdict = given(answer, "verdict");
  out.status = status ? read_status(*status) : Status::converged;
  out.verdict = verdict ? read_verdict(*verdict) : verdict_of(out.overlap);
  if (const auto count = given(answer, "iterations")) out.iterations = count->count();
  if (const auto count = given(answer, "evaluations")) out.evaluations = count->count();
  return out;
}

int sign_of(double overlap) {
  return (overlap > 0) - (overlap < 0);
}

Json angles_json(const Pair& pair, const Contact<double>& contact, int overlap_sign) {
  const Diagnosis diagnosis = diagnose(pair, contact.point1, contact.point2, overlap_sign < 0 ? -1 : 1);
  Json out;
  if (overlap_sign != 0) {
    put(out, "d_n1", diagnosis.d_n1);
    put(out, "d_n2", diagnosis.d_n2);
  }
  put(out, "n1_n2", diagnosis.n1_n2);
  return out;
}

Json contact_json(const Contact<double>& contact, const Want& want) {
  Json out;
  out["status"] = name(contact.status);
  out["verdict"] = name(contact.verdict);
  if (want.overlap) put(out, "overlap", contact.overlap);
  if (want.normal) put(out, "normal", contact.normal);
  if (want.points) {
    put(out, "points", contact.point1, contact.point2);
    put(out, "contact_point", contact.contact_point);
  }
  out["iterations"] = contact.iterations;
  out["evaluations"] = contact.evaluations;
  return out;
}

Json answer_json(const Answer& answer) {
  const Contact<double>& contact = answer.contact;
  Json out;
  out["name"] = answer.name;
  out["method"] = contact.method;
  if (answer.problem != Problem::common_normal) out["x_problem"] = name(answer.problem);
  if (answer.none) {
    out["x_finding"] = answer.none->finding;
    out["x_detail"] = answer.none->detail;
    return out;
  }
  out.update(contact_json(contact, answer.want));
  if (answer.want.points && answer.pair) {
    put_object(out, "angles_deg", angles_json(*answer.pair, contact, sign_of(contact.overlap)));
    put_object(out, "residuals", residues_json(*answer.pair, contact));
  }
  if (answer.want.curvature) put_curvature(out, contact);
  if (answer.want.derivatives) put_derivatives(out, contact);
  if (answer.want.patch) put_patch(out, contact);
  if (answer.nanoseconds) out["timing"]["ns"] = *answer.nanoseconds;
  return out;
}

GivenAnswer parse_answer(const std::string& text, const std::string& file, int line) {
  try {
    const Json tree = read_json(text);
    return read_answer(Field(tree));
  } catch (const FieldError& error) {
    throw InputFailure(file, line, error.field, error.what());
  }
}

AnswerReader::AnswerReader(const std::string& path)
    : objects_(path, ObjectReader::Layout::by_content), numbered_(std::filesystem::path(path).extension() == ".jsonl") {
}

std::optional<GivenAnswer> AnswerReader::next() {
  const std::optional<std::string> text = objects_.next();
  if (!text) return std::nullopt;
  if (std::exchange(any_, true)) numbered_ = true;
  return parse_answer(*text, objects_.file(), line());
}

}  // namespace plumb
