#include "reports/document/issue.hpp"

#include <fmt/format.h>

#include <array>

#include "corpus/case/contract_words.hpp"
#include "corpus/command/build_info.hpp"
#include "corpus/json/fields.hpp"
#include "properties/laws/judged_answer.hpp"
#include "properties/laws/screen.hpp"

namespace plumb::reports {
namespace {

std::string list(const Vec3<double>& v) {
  return v.allFinite() ? write_json(vector_json(v)) : "none";
}

std::string number(double x) {
  return std::isfinite(x) ? shortest(x) : "none";
}

std::string body_row(int i, const Body& body) {
  const auto [w, x, y, z] = body.quaternion;
  return fmt::format("| {} | {} | {}, {} | {} | [{}, {}, {}, {}] |\n", i, list(body.shape.semi_axes),
                     shortest(body.shape.n1), shortest(body.shape.n2), list(body.position), shortest(w), shortest(x),
                     shortest(y), shortest(z));
}

std::string pair_text(const Pair& pair) {
  return "Surfaces (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes; the quaternion (w, x, y, z) takes body "
         "axes to the "
         "world.\n\n| body | semi-axes a, b, c | n1, n2 | position | quaternion |\n|---|---|---|---|---|\n" +
         body_row(1, pair.body1) + body_row(2, pair.body2);
}

struct Told {
  double overlap;
  Vec3<double> normal, point1, point2;
};

std::string told_text(const Told& expected, const Told& got) {
  std::string out = "\n| | expected | got |\n|---|---|---|\n";
  out += fmt::format("| overlap (negative: apart) | {} | {} |\n", number(expected.overlap), number(got.overlap));
  const std::array<std::pair<const char*, Vec3<double> Told::*>, 3> rows{
      {{"normal, from body 1 to body 2", &Told::normal},
       {"point on body 1", &Told::point1},
       {"point on body 2", &Told::point2}}};
  for (const auto& [words, which] : rows)
    out += fmt::format("| {} | {} | {} |\n", words, list(expected.*which), list(got.*which));
  return out;
}

std::string python_list(double a, double b, double c) {
  return fmt::format("[{}, {}, {}]", shortest(a), shortest(b), shortest(c));
}

std::string python_body(const Body& body) {
  const auto [w, x, y, z] = body.quaternion;
  const Vec3<double>&a = body.shape.semi_axes, &at = body.position;
  return fmt::format("({}, {}, {}, [{}, {}, {}, {}], {})", python_list(a[0], a[1], a[2]), shortest(body.shape.n1),
                     shortest(body.shape.n2), shortest(w), shortest(x), shortest(y), shortest(z),
                     python_list(at[0], at[1], at[2]));
}

/// Five lines that define the depth along a direction, then the bodies, the two directions, and the overlap that was told.
std::string by_hand(const Pair& pair, const Told& expected, const Told& got) {
  std::string out =
      "\nBy hand: o(n) is how far body 2 has to go along the unit vector n until a plane across n parts the bodies. "
      "The overlap is the "
      "least of it over all n, so a direction with a lower o(n) shows that the other is not the normal.\n\n```python\n"
      "import numpy as np\n"
      "turn = lambda q, v: v + 2 * np.cross(q[1:], np.cross(q[1:], v) + q[0] * v) / np.dot(q, q)\n"
      "def h(body, n): a, n1, n2, q, x = body; p, r = n1 / (n1 - 1), n2 / (n2 - 1); u = abs(np.array(a) * "
      "turn(np.array([q[0], -q[1], "
      "-q[2], -q[3]]), n)); return ((u[0]**r + u[1]**r)**(p / r) + u[2]**p)**(1 / p)\n"
      "o = lambda n: h(one, n) + h(two, -n) - n @ (np.array(two[4]) - np.array(one[4]))\n";
  out += fmt::format("one, two = {}, {}\n", python_body(pair.body1), python_body(pair.body2));
  for (const auto& [word, told] : {std::pair{"expected", expected}, std::pair{"got", got}})
    if (const Vec3<double>& n = told.normal; n.allFinite())
      out += fmt::format("n = np.array({}); print(\"{}\", o(n / np.linalg.norm(n)))\n", python_list(n[0], n[1], n[2]),
                         word);
  if (std::isfinite(got.overlap)) out += fmt::format("print(\"told\", {})\n", shortest(got.overlap));
  return out + "```\n";
}

double depth(const Pair& pair, const Vec3<double>& n) {
  return static_cast<double>(depth_along(pair, n.cast<long double>().normalized()));
}

/// What the answer says against what its own normal shows, and that against the right one: what a maintainer looks at first.
std::string common_normal_text(const Pair& pair, const JudgedAnswer& judged, const Told& expected, const Told& got) {
  if (!got.normal.allFinite()) return {};
  const double own = depth(pair, got.normal), least = depth(pair, expected.normal);
  std::string out;
  if (const double off = judged.judgement.angle_error_deg; off > 0)
    out += fmt::format("The normal is {:.3g} degrees from the right one. Until a plane parts the bodies, body 2 has to "
                       "go {:.6g} along "
                       "it, and {:.6g} along the right one. ",
                       off, own, least);
  if (std::isfinite(got.overlap))
    out += fmt::format("The overlap that it tells is {:.6g}; its own normal gives {:.6g}. ", got.overlap, own);
  return out.empty() ? out : out + "\n\n";
}

/// What "expected" rests on, what was asked for, and how to see it again.
std::string origin_text(const JudgedAnswer& judged, const Accuracy& accuracy, const std::string& command) {
  const Contact<double>& answer = judged.answer;
  const std::string told = answer.method.empty()
                               ? "Nothing was told"
                               : fmt::format("Status told: {}; verdict told: {}; {} iterations", name(answer.status),
                                             name(answer.verdict), answer.iterations);
  return fmt::format(
      "\n{}. Accuracy asked for: {}. What is expected is certified by interval arithmetic on these very numbers (plumb "
      "{}). To see it again:\n\n    {}\n",
      told, accuracy_text(accuracy), build_info().commit, command);
}

}  // namespace

Issue issue(const Case& c, const Solver& solver, const Accuracy& accuracy, const std::string& command) {
  Judge judge(c.pair);
  const JudgedAnswer judged = solve_and_judge(judge, c.pair, solver, accuracy);
  const Finding& finding = judged.judgement.finding;
  if (finding.kind == FindingKind::none) return {};
  const bool is_common_normal = solver.abilities.problem == Problem::common_normal;
  const Solution& truth = judge.solution(solver.abilities.problem);
  const Told expected{static_cast<double>(truth.overlap), truth.normal.cast<double>(), truth.point1.cast<double>(),
                      truth.point2.cast<double>()};
  const Told got{judged.answer.overlap, judged.answer.normal, judged.answer.point1, judged.answer.point2};
  const std::string who = solver.abilities.name.empty() ? solver.name : solver.abilities.name;
  std::string text = fmt::format("# {} {}: {}\n\n", who, solver.abilities.version, name(finding.kind));
  if (is_common_normal) text += common_normal_text(c.pair, judged, expected, got);
  text += fmt::format("{} ({}).\n\n", finding.detail, meaning(finding.kind));
  text += pair_text(c.pair) + told_text(expected, got);
  if (is_common_normal) text += by_hand(c.pair, expected, got);
  return {text + origin_text(judged, accuracy, command), true};
}

}  // namespace plumb::reports
