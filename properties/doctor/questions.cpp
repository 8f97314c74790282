#include "properties/doctor/questions.hpp"

#include <array>
#include <stdexcept>

#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::doctor {
namespace {

// Quaternions of length 1 with four different parts, and no two bodies turned alike.
constexpr std::array<std::array<double, 4>, 6> kTurns{{{0.7, 0.1, 0.5, 0.5},
                                                       {0.8, 0.4, -0.2, 0.4},
                                                       {0.5, 0.7, 0.1, -0.5},
                                                       {0.1, 0.7, 0.5, 0.5},
                                                       {0.4, 0.2, 0.8, 0.4},
                                                       {0.5, -0.1, 0.7, 0.5}}};

struct Exponents {
  double n1 = 2, n2 = 2;
};

Body body(const Vec3<double>& axes, const Vec3<double>& position, std::size_t turn, Exponents exponents = {}) {
  return {{axes, exponents.n1, exponents.n2}, position, kTurns[turn]};
}

Body sphere(double radius, const Vec3<double>& position, std::size_t turn) {
  return body(Vec3<double>::Constant(radius), position, turn);
}

Question question(std::string words, Kind kind, const Body& body1, const Body& body2) {
  return {std::move(words), kind, Variation::none, {body1, body2}, {}};
}

/// Overlaps are 0.15 to 0.3 of the size: no field is small. Body 1 is at the origin in the first alone, to be read easily.
std::vector<Question> spheres() {
  const Vec3<double> along(0.48, -0.6, 0.64);
  const auto beside = [&](const Vec3<double>& position, double distance) {
    return Vec3<double>(position + distance * along);
  };
  const Vec3<double> at1(0.4, -0.3, 0.6), at2(-0.5, 0.7, 0.3), at3(0.6, 0.5, -0.4);
  Body first = sphere(1, Vec3<double>::Zero(), 0), second = sphere(1, beside(Vec3<double>::Zero(), 1.75), 0);
  first.quaternion = second.quaternion = {1, 0, 0, 0};
  return {question("two equal spheres", Kind::spheres, first, second),
          question("two spheres", Kind::spheres, sphere(1.5, at1, 0), sphere(0.6, beside(at1, 1.8), 1)),
          question("two equal spheres, turned", Kind::spheres, sphere(0.7, at2, 2), sphere(0.7, beside(at2, -1.2), 3)),
          question("two spheres apart", Kind::spheres, sphere(0.8, at3, 4), sphere(1.3, beside(at3, -2.5), 5)),
          question("two equal spheres apart", Kind::spheres, sphere(1, at1, 3), sphere(1, beside(at1, 2.25), 2))};
}

/// No semi-axis of a pair is twice another: a body twice as large is no body turned.
std::vector<Question> ellipsoids() {
  return {question("two triaxial ellipsoids", Kind::ellipsoids, body({1.2, 0.8, 0.5}, {0.4, -0.3, 0.6}, 0),
                   body({0.6, 1.0, 0.7}, {1.04, 0.15, 1.05}, 1)),
          question("two other triaxial ellipsoids", Kind::ellipsoids, body({0.5, 0.9, 1.3}, {-0.5, 0.7, 0.3}, 2),
                   body({1.1, 0.6, 0.8}, {0.3, -0.25, -0.15}, 3)),
          question("a prolate and an oblate spheroid", Kind::ellipsoids, body({0.7, 0.7, 1.5}, {0.6, 0.5, -0.4}, 1),
                   body({1.0, 1.0, 0.4}, {0.05, 1.15, 0.61}, 4)),
          question("two triaxial ellipsoids apart", Kind::ellipsoids, body({0.8, 1.4, 0.6}, {0.3, -0.8, -0.5}, 5),
                   body({0.9, 0.5, 1.2}, {0.66, 1.25, 0.06}, 0))};
}

/// The last two have exponents below 2, whose inverses 2/n are exponents as well.
std::vector<Question> superellipsoids() {
  return {question("two superellipsoids", Kind::superellipsoids,
                   body({1.2, 0.8, 0.6}, {0.4, -0.3, 0.6}, 1, {.n1 = 3, .n2 = 6}),
                   body({0.7, 1.0, 0.9}, {1.74, -0.79, 1.8}, 2, {.n1 = 5, .n2 = 2.5})),
          question("two superellipsoids apart", Kind::superellipsoids,
                   body({0.6, 1.1, 0.9}, {-0.5, 0.7, 0.3}, 3, {.n1 = 6, .n2 = 3}),
                   body({1.3, 0.7, 0.8}, {0.56, 2.54, -0.08}, 5, {.n1 = 2.5, .n2 = 4})),
          question("two pointed superellipsoids", Kind::superellipsoids,
                   body({1.1, 0.7, 0.9}, {0.6, 0.5, -0.4}, 4, {.n1 = 1.3, .n2 = 1.7}),
                   body({0.8, 1.2, 0.6}, {-0.67, 1.23, 0.28}, 0, {.n1 = 1.6, .n2 = 1.2})),
          question("two other pointed superellipsoids", Kind::superellipsoids,
                   body({0.7, 1.2, 1.0}, {0.3, -0.8, -0.5}, 0, {.n1 = 1.8, .n2 = 1.25}),
                   body({1.0, 0.8, 1.3}, {0.89, -1.82, -0.29}, 3, {.n1 = 1.2, .n2 = 1.7}))};
}

template <class Change>
Question varied(Question of, Variation variation, const std::string& words, const Change& change) {
  of.words += ", " + words;
  of.variation = variation;
  change(of.pair.body1);
  change(of.pair.body2);
  return of;
}

Question in_unit(const Question& of, double unit, const std::string& words) {
  return varied(of, Variation::unit, words, [&](Body& body) {
    body.shape.semi_axes *= unit;
    body.position *= unit;
  });
}

/// So far that nobody misses it, and that positions in float are still good to 1e-5 of the size.
Question far_away(const Question& of) {
  const Vec3<double> far(60, -80, 50);
  return varied(of, Variation::place, "far from the origin", [&](Body& body) { body.position += far; });
}

Question with_long_quaternions(const Question& of) {
  double length = 2.5;
  return varied(of, Variation::quaternion, "quaternions of length 2.5 and 0.4", [&](Body& body) {
    for (double& part : body.quaternion) part *= length;
    length = 0.4;
  });
}

void append_variations(std::vector<Question>& out, const Question& of) {
  out.push_back(in_unit(of, 1e-3, "all lengths times 0.001"));
  out.push_back(in_unit(of, 1e3, "all lengths times 1000"));
  out.push_back(far_away(of));
}

/// The solution of the pair's own problem, in doubles of proved accuracy.
Solution certified(const Pair& pair, Problem problem) {
  return problem == Problem::common_normal ? find_reference(pair, Effort::bounds).common_normal
                                           : find_problem_reference(pair, problem);
}

/// plumb's answers are good to rounding; what is off by more is another solution.
bool confirms(const Solution& reference, const Contact<double>& answer, double size) {
  const double most = 1e-9;
  const double off = std::abs(static_cast<double>(reference.overlap) - answer.overlap) / size;
  const double turned = (reference.normal.cast<double>() - answer.normal).norm();
  return answer.status == Status::converged && reference.solved && off < most && turned < most;
}

std::string_view method_for(Problem problem) {
  if (problem == Problem::deepest_points) return "geometric_potential";
  return problem == Problem::midway ? "geometric_potential_midway" : "auto";
}

}  // namespace

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, 3> names{"spheres", "ellipsoids", "superellipsoids"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Question> all_questions() {
  std::vector<Question> out = spheres();
  append_variations(out, out[1]);
  const std::vector<Question> smooth = ellipsoids(), other = superellipsoids();
  out.insert(out.end(), smooth.begin(), smooth.end());
  append_variations(out, smooth[1]);
  out.push_back(with_long_quaternions(smooth[1]));
  out.push_back(with_long_quaternions(smooth[3]));
  out.insert(out.end(), other.begin(), other.end());
  return out;
}

Contact<double> own_answer(const Pair& pair, Problem problem) {
  return find_method(method_for(problem))->solve(pair, {}, nullptr);
}

std::vector<Question> questions_for(const Abilities& abilities) {
  std::vector<Question> out;
  for (Question& each : all_questions()) {
    each.truth = own_answer(each.pair, abilities.problem);
    if (!abilities.claims(each.pair, each.truth.verdict)) continue;
    if (confirms(certified(each.pair, abilities.problem), each.truth, size_of(each.pair)))
      out.push_back(std::move(each));
  }
  return out;
}

}  // namespace plumb::doctor
