// The helpers for solvers in Python and JavaScript, and the example of each: right, and found out where it is made wrong.
#include <gtest/gtest.h>

#include <random>

#include "properties/laws/judged_answer.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

struct Language {
  std::string program, helper, example, ending;
};
const std::string kSolver = std::string(PLUMB_SOURCE_DIR) + "/solver/";
const Language kInPython{PLUMB_PYTHON, kSolver + "python/plumb_solver.py", kSolver + "python/example/spheres.py",
                         ".py"};
const Language kInJavaScript{PLUMB_NODE, kSolver + "js/plumb_solver.mjs", kSolver + "js/example/ellipsoids.mjs",
                             ".mjs"};

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class Draws {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(engine_); }
  Vec3<double> direction() {
    std::normal_distribution<> normal;
    const Vec3<double> v(normal(engine_), normal(engine_), normal(engine_));
    return v / v.norm();
  }
  /// In any unit, far from the origin, with a quaternion of any length.
  Pair ellipsoids(bool spheres) {
    const double unit = std::exp2(std::floor(between(-300, 300)));
    Pair pair;
    for (Body* body : {&pair.body1, &pair.body2}) {
      for (double& a : body->shape.semi_axes) a = unit * between(0.5, 1.5);
      if (spheres) body->shape.semi_axes.setConstant(body->shape.semi_axes[0]);
      const Vec3<double> v = direction();
      body->quaternion = {between(-1, 1) * unit, v[0] * unit, v[1] * unit, v[2] * unit};
    }
    pair.body1.position = 4 * unit * direction();
    pair.body2.position = pair.body1.position + unit * between(0.5, 3) * direction();
    return pair;
  }

 private:
  std::mt19937_64 engine_{1};
};

class Examples : public Commands {
 protected:
  /// Of answers to so many pairs that the example claims.
  static int findings(const Language& language, const std::string& example) {
    constexpr int pairs = 40;
    const Solver solver = load_solver_command(language.program + " " + example);
    const bool spheres = solver.abilities.shapes == Shapes::spheres;
    EXPECT_EQ(solver.name, "solver:" + fs::path(language.example).filename().string());
    Draws draws;
    int found = 0;
    for (int i = 0; i < pairs; ++i) {
      const Pair pair = draws.ellipsoids(spheres);
      Judge judge(pair);
      const Finding finding = judge.judge(Problem::common_normal, solver.solve(pair, {}, nullptr)).finding;
      found += finding.kind != FindingKind::none;
    }
    return found;
  }
  /// The example with one mistake planted, beside its helper.
  [[nodiscard]] std::string planted(const Language& language, const std::string& right,
                                    const std::string& wrong) const {
    std::string text = text_of(language.example);
    const std::size_t at = text.find(right);
    EXPECT_NE(at, std::string::npos) << right;
    text.replace(at, right.size(), wrong);
    fs::create_directories(path_ / "example");
    fs::copy_file(language.helper, path_ / fs::path(language.helper).filename(), fs::copy_options::overwrite_existing);
    return file("example/" + fs::path(language.example).filename().string(), text);
  }
};

/// Programs that answer with the two support points along r and -r, and with nothing to solve.
const std::string kPythonSupport = R"(from plumb_solver import serve
def solve(pair):
    one, two = pair.bodies
    r = [q - p for p, q in zip(one.position, two.position)]
    return pair.answer(points=[one.support_point(r), two.support_point([-v for v in r])])
serve(solve, {}))";
const std::string kJavaScriptSupport = R"(import { scale, serve, subtract } from './plumb_solver.mjs';
await serve((pair) => {
  const [one, two] = pair.bodies;
  const r = subtract(two.position, one.position);
  return pair.answer({ points: [one.supportPoint(r), two.supportPoint(scale(-1, r))] });
}, {});)";

Vec3<double> support_of(const Body& body, const Vec3<double>& direction) {
  const Mat3<double> rotation = place<double>(Pair{body, body}).body1.rotation;
  const Vec3<double> local = support_point<double>(body.shape, rotation.transpose() * direction).gradient;
  return body.position + rotation * local;
}

void expect_support_points(const Solver& solver) {
  Draws draws;
  for (int i = 0; i < 200; ++i) {
    Pair pair = draws.ellipsoids(false);
    for (Body* body : {&pair.body1, &pair.body2}) {
      body->shape.n1 = draws.between(1.2, 8);
      body->shape.n2 = draws.between(1.2, 8);
    }
    const Vec3<double> r = (pair.body2.position - pair.body1.position).stableNormalized();
    const Contact<double> answer = solver.solve(pair, {}, nullptr);
    const double allowed = 1e-12 * pair.body1.position.stableNorm();
    EXPECT_LE((answer.point1 - support_of(pair.body1, r)).stableNorm(), allowed) << i;
    EXPECT_LE((answer.point2 - support_of(pair.body2, -r)).stableNorm(), allowed) << i;
  }
}

TEST_F(Examples, PythonsHasNoFindingsAndAWrongOneHas) {
  if (kInPython.program.empty()) GTEST_SKIP() << "needs python3";
  EXPECT_EQ(findings(kInPython, kInPython.example), 0);
  EXPECT_GT(findings(kInPython, planted(kInPython, "p - radius2 * n", "p + radius2 * n")), 20);
}

TEST_F(Examples, JavaScriptsHasNoFindingsAndAWrongOneHas) {
  if (kInJavaScript.program.empty()) GTEST_SKIP() << "needs node";
  EXPECT_EQ(findings(kInJavaScript, kInJavaScript.example), 0);
  EXPECT_GT(findings(kInJavaScript, planted(kInJavaScript, "subtract(offset, two.point)", "add(offset, two.point)")),
            20);
}

TEST_F(Examples, TheHelpersSupportPointsAreThoseOfPlumb) {
  if (!kInPython.program.empty()) {
    fs::copy_file(kInPython.helper, path_ / "plumb_solver.py");
    expect_support_points(load_solver_command(kInPython.program + " " + file("s.py", kPythonSupport)));
  }
  if (kInJavaScript.program.empty()) GTEST_SKIP() << "needs node";
  fs::copy_file(kInJavaScript.helper, path_ / "plumb_solver.mjs");
  expect_support_points(load_solver_command(kInJavaScript.program + " " + file("s.mjs", kJavaScriptSupport)));
}

}  // namespace
}  // namespace plumb
