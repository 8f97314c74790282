// plumb doctor: whether the adapter of a foreign solver is sane, before anything else is asked of it.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "corpus/case/body_json.hpp"
#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "properties/doctor/diagnosis.hpp"

namespace plumb {
namespace {

using doctor::Diagnosis;
using doctor::Question;
using doctor::Reply;

struct Options {
  ForeignOption foreign;
  bool json = false;
};

void declare(CommandLine& app, Options& options) {
  declare_solver(app, options.foreign, "a shared library that implements solver/plumb_solver.h");
  app.add_flag("--json", options.json, "one JSON object");
}

std::string vector_text(const Vec3<double>& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

std::string body_text(const Body& body) {
  const auto [w, x, y, z] = body.quaternion;
  std::string out = "semi-axes " + vector_text(body.shape.semi_axes);
  if (body.shape.n1 != 2 || body.shape.n2 != 2)
    out += fmt::format(", exponents ({:.6g}, {:.6g})", body.shape.n1, body.shape.n2);
  out += ", position " + vector_text(body.position);
  if (x != 0 || y != 0 || z != 0) out += fmt::format(", quaternion ({:.6g}, {:.6g}, {:.6g}, {:.6g})", w, x, y, z);
  return out;
}

std::string answer_text(const Contact<double>& answer, const Abilities& abilities) {
  if (doctor::is_bare_verdict(answer, abilities)) return std::string(name(answer.verdict));
  if (answer.status != Status::converged) return "status " + std::string(name(answer.status));
  std::string out = fmt::format("{}, overlap {:.6g}", name(answer.verdict), answer.overlap);
  if (abilities.normal) out += ", normal " + vector_text(answer.normal);
  if (abilities.points == Points::two)
    out += ", points " + vector_text(answer.point1) + " and " + vector_text(answer.point2);
  if (abilities.points == Points::midway) out += ", contact point " + vector_text(answer.contact_point);
  return out;
}

/// The simplest pair that shows the mistake, in numbers that anybody can check.
std::string evidence_text(const Diagnosis& d, const Abilities& abilities, std::size_t at) {
  const Question& question = d.questions[at];
  std::string out = fmt::format("  pair      {}\n  body 1    {}\n  body 2    {}\n  expected  {}", question.words,
                                body_text(question.pair.body1), body_text(question.pair.body2),
                                answer_text(question.truth, abilities));
  if (at < d.replies.size()) out += "\n  got       " + answer_text(d.replies[at].contact, abilities);
  return out;
}

std::string diagnosis_text(const Diagnosis& d, const Solver& solver) {
  std::string out = solver.name + ": " + d.said.sentence;
  for (const doctor::Named& other : d.others) out += "\n  or        " + other.sentence;
  if (d.evidence) out += "\n" + evidence_text(d, solver.abilities, *d.evidence);
  return out;
}

void put(Json& out, const char* key, const Vec3<double>& v) {
  if (v.allFinite()) out[key] = vector_json(v);
}

Json answer_json(const Contact<double>& answer) {
  Json out;
  out["status"] = name(answer.status);
  out["verdict"] = name(answer.verdict);
  if (std::isfinite(answer.overlap)) out["overlap"] = answer.overlap;
  put(out, "normal", answer.normal);
  if (answer.point1.allFinite() && answer.point2.allFinite())
    out["points"] = {vector_json(answer.point1), vector_json(answer.point2)};
  put(out, "contact_point", answer.contact_point);
  return out;
}

Json evidence_json(const Diagnosis& d, std::size_t at) {
  const Question& question = d.questions[at];
  Json out;
  out["pair"] = question.words;
  out["bodies"] = {body_json(question.pair.body1), body_json(question.pair.body2)};
  out["expected"] = answer_json(question.truth);
  if (at < d.replies.size()) out["got"] = answer_json(d.replies[at].contact);
  return out;
}

/// By kind of shape: "asked", "answered", "right".
Json pairs_json(const Diagnosis& d) {
  Json out = Json::object();
  for (std::size_t i = 0; i < d.questions.size(); ++i) {
    Json& row = out[std::string(name(d.questions[i].kind))];
    if (row.is_null()) row = {{"asked", 0}, {"answered", 0}, {"right", 0}};
    const Reply reply = i < d.replies.size() ? d.replies[i] : Reply{};
    row["asked"] = row["asked"].get<int>() + 1;
    row["answered"] = row["answered"].get<int>() + reply.answered;
    row["right"] = row["right"].get<int>() + reply.right;
  }
  return out;
}

Json diagnosis_json(const Diagnosis& d, const Solver& solver) {
  Json out;
  out["solver"] = solver.name;
  out["abilities"] = abilities_json(solver.abilities);
  out["sane"] = d.sane;
  out["mistake"] = d.said.word.empty() ? Json(nullptr) : Json(d.said.word);
  for (const doctor::Named& other : d.others) out["or"].push_back(other.word);
  out["sentence"] = d.said.sentence;
  out["pairs"] = pairs_json(d);
  if (d.sane)
    out["worst"] = {{"normal_deg", d.worst.normal * 180 / std::numbers::pi},
                    {"overlap", d.worst.overlap},
                    {"points", d.worst.points}};
  if (d.evidence) out["evidence"] = evidence_json(d, *d.evidence);
  return out;
}

int examine(const Options& options) {
  const std::optional<Solver> solver = solver_instead(options.foreign, "", "plumb doctor");
  if (!solver) throw InputFailure("plumb doctor", 0, "--solver", "or --solver-command is missing");
  const Diagnosis d = doctor::diagnose(*solver);
  print_line(options.json ? write_json(diagnosis_json(d, *solver)) : diagnosis_text(d, *solver));
  return d.sane ? exit_done : exit_finding;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app(
      "Whether a foreign solver's adapter is sane, and the usual mistake if it is not; 1 if it is not.",
      "plumb doctor");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::examine(options); });
}
