// The adapters of real contact solvers (fuzz/peers/board, target board_peers): each that is built says what it answers and is
// right on ordinary spheres. Where the library itself is not, the row says so.
#include <gtest/gtest.h>

#include <cmath>

#include "corpus/solvers/solver.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

struct Row {
  std::string name, version, licence;
  double normal = 1e-3;  ///< radians; the overlap and the points are held to 1e-3 of the size everywhere
  double least = 1;      ///< of the pairs that overlap, the share that is right
  std::string why = {};
};

void PrintTo(const Row& row, std::ostream* os) {
  *os << row.name;
}

// EPA_ACCURACY of the build in float is a depth of 1e-4: the normal is known to the root of it.
constexpr double kFloatNormal = 0.1;
const std::string kReversed = "where EPA's normal is reversed Bullet turns it, and leaves its point on the far side";

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"bullet-pair-double", "3.24", "Zlib", 1e-3, 0.8, kReversed},
      {"bullet-pair-float", "3.24", "Zlib", kFloatNormal, 0.95, kReversed},
      {"bullet-epa-double", "3.24", "Zlib"},
      {"bullet-epa-float", "3.24", "Zlib", kFloatNormal},
      {"bullet-mpr-double", "3.24", "Zlib"},
      {"bullet-mpr-float", "3.24", "Zlib"},
      {"simbody", "3.7", "Apache-2.0", 1e-3, 0.98, "Simbody's Newton ends at the common normal on the far sides"},
      {"mujoco", "2.2.2", "Apache-2.0"},
      {"dart-fcl", "6.12.1", "BSD-2-Clause"},
      {"nlopt-slsqp", "2.7.1", "LGPL-2.1-or-later"},
      {"ceres-equations", "2.1.0", "BSD-3-Clause"},
      {"ipopt-distance", "3.11.9", "EPL-1.0"},
  };
  return all;
}

fs::path folder() {
  return fs::path(PLUMB_BINARY_DIR) / "board";
}

struct Balls {
  Pair pair;
  Vec3<double> along;  // from 1 to 2
  double overlap = 0;

  [[nodiscard]] Vec3<double> middle() const {
    return pair.body1.position + along * (pair.body1.shape.semi_axes[0] - overlap / 2);
  }
};

/// In general position: any size up to five to one, any unit, anywhere, turned; 5 to 30 % of the smaller radius deep or apart.
Balls draw_balls(std::uint64_t seed, double sign) {
  Stream stream("balls", seed, 0);
  Balls out;
  const double unit = std::pow(10.0, stream.uniform(-6, 6));
  const double radius1 = unit * stream.uniform(0.4, 2), radius2 = unit * stream.uniform(0.4, 2);
  out.pair.body1.shape.semi_axes.setConstant(radius1);
  out.pair.body2.shape.semi_axes.setConstant(radius2);
  out.pair.body1.quaternion = random_rotation(stream);
  out.pair.body2.quaternion = random_rotation(stream);
  out.along = random_direction(stream);
  out.overlap = sign * stream.uniform(0.05, 0.3) * std::min(radius1, radius2);
  out.pair.body1.position = 10 * unit * random_direction(stream);
  out.pair.body2.position = out.pair.body1.position + (radius1 + radius2 - out.overlap) * out.along;
  return out;
}

bool is_right(const Contact<double>& answer, const Balls& balls, double normal) {
  const double allowed = 1e-3 * size_of(balls.pair);
  return answer.status == Status::converged && std::abs(answer.overlap - balls.overlap) < allowed &&
         (answer.normal - balls.along).norm() < normal &&
         (answer.contact_point - balls.middle()).norm() < std::max(1e-3, normal) * size_of(balls.pair);
}

class Board : public testing::TestWithParam<Row> {
 protected:
  void SetUp() override {
    const fs::path library = folder() / (GetParam().name + ".so");
    if (!fs::exists(library)) GTEST_SKIP() << "not built: ninja board_peers, where its package is installed";
    solver_ = load_solver(library.string());
  }

  [[nodiscard]] Contact<double> ask(const Balls& balls) const { return solver_.solve(balls.pair, {}, nullptr); }

  Solver solver_;
};

constexpr std::uint64_t kPairs = 200;

TEST_P(Board, SaysWhatItIsAndAnswers) {
  const Abilities& said = solver_.abilities;
  EXPECT_EQ(solver_.name, "solver:" + GetParam().name);
  EXPECT_EQ(said.version, GetParam().version);
  EXPECT_EQ(said.licence, GetParam().licence);
  EXPECT_GT(said.tolerance, 0);
}

TEST_P(Board, IsRightOnOrdinarySpheresThatOverlap) {
  std::uint64_t right = 0;
  std::string wrong;
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const Balls balls = draw_balls(i, 1);
    if (is_right(ask(balls), balls, GetParam().normal))
      ++right;
    else
      wrong += " " + std::to_string(i);
  }
  RecordProperty("right", static_cast<int>(right));
  EXPECT_GE(static_cast<double>(right), GetParam().least * kPairs) << "wrong:" << wrong;
  EXPECT_TRUE(GetParam().least == 1 || !GetParam().why.empty());
}

TEST_P(Board, IsRightOnOrdinarySpheresApart) {
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const Balls balls = draw_balls(i, -1);
    const Contact<double> answer = ask(balls);
    EXPECT_EQ(answer.verdict, Verdict::separated) << i;
    // In float the gap is a difference of squares: its direction is the root of what the distance is good for.
    if (solver_.abilities.apart != Apart::distance) continue;
    EXPECT_TRUE(is_right(answer, balls, std::max(GetParam().normal, 0.01))) << i << ": " << answer.overlap;
  }
}

TEST_P(Board, RefusesWhatItDoesNotClaim) {
  Balls balls = draw_balls(0, 1);
  balls.pair.body2.shape.n1 = 4;
  const bool claimed = solver_.abilities.takes(balls.pair);
  EXPECT_EQ(ask(balls).status == Status::invalid_input, !claimed);
}

TEST_P(Board, AnswersAgainWhatItAnswered) {
  const Balls first = draw_balls(0, 1);
  const Contact<double> before = ask(first);
  (void)ask(draw_balls(1, 1));
  (void)ask(draw_balls(2, -1));
  const Contact<double> again = ask(first);
  EXPECT_EQ(before.overlap, again.overlap);
  EXPECT_EQ(before.normal, again.normal);
}

INSTANTIATE_TEST_SUITE_P(Peers, Board, testing::ValuesIn(rows()), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(BoardFolder, HoldsNoLibraryWithoutARow) {
  if (!fs::exists(folder())) GTEST_SKIP() << "not built: ninja board_peers";
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_TRUE(entry.path().extension() != ".so" ||
                std::any_of(rows().begin(), rows().end(),
                            [&](const Row& row) { return row.name == entry.path().stem().string(); }))
        << entry.path();
}

// Programs over the library and nothing of plumb: exit 1 where a ball's answer is wrong.
TEST(BoardFolder, TheWrongAnswersOnSpheresAreTheLibrarysOwn) {
  const fs::path alone = folder() / "alone";
  if (!fs::exists(alone)) GTEST_SKIP() << "not built: ninja board_peers";
  for (const auto& program : fs::directory_iterator(alone))
    EXPECT_EQ(run(program.path().string()).code, 1) << program.path();
}

}  // namespace
}  // namespace plumb
