// Random motions: along each the warm answer is the cold one, to rounding.
#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/draws.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// How body 2 goes on at each step, and where it came to last.
struct Motion {
  Pair pair;
  Quaternion turned, turned1;
  Vec3<double> shift;
  Stream stream;

  Motion(const char* family, std::uint64_t index)
      : pair(generate(family, 77, index).pair), stream("motions", 7, index) {
    const double step = stream.log_uniform(1e-5, 3e-2);
    turned = turn(random_direction(stream), step * stream.log_uniform(0.1, 3));
    turned1 = turn(random_direction(stream), step);
    shift = random_direction(stream) * (step * size_of(pair) * stream.uniform());
  }
};

void slide(Motion& m, int /*step*/, const Contact<double>& /*last*/) {
  m.pair.body2.position += m.shift;
  m.pair.body2.quaternion = product(m.turned, m.pair.body2.quaternion);
}
void spin(Motion& m, int /*step*/, const Contact<double>& /*last*/) {
  m.pair.body1.quaternion = product(m.turned1, m.pair.body1.quaternion);
  m.pair.body2.quaternion = product(m.turned, m.pair.body2.quaternion);
}
/// Round body 1, at an overlap of 5e-3 sizes.
void roll(Motion& m, int /*step*/, const Contact<double>& last) {
  const double size = size_of(m.pair);
  const Vec3<double> arm = m.pair.body2.position - m.pair.body1.position;
  m.pair.body2.position = m.pair.body1.position + rotation<double>(m.turned) * arm;
  m.pair.body2.quaternion = product(m.turned, m.pair.body2.quaternion);
  if (std::abs(last.overlap) < size) m.pair.body2.position += (last.overlap - 5e-3 * size) * last.normal;
}
/// To and fro, with a jump each 50 steps.
void shake(Motion& m, int step, const Contact<double>& /*last*/) {
  m.pair.body2.position += std::cos(0.3 * step) * m.shift;
  m.pair.body2.quaternion = product(m.turned, m.pair.body2.quaternion);
  if (step % 50 == 49) m.pair.body2.position += random_direction(m.stream) * (0.2 * size_of(m.pair));
}

TEST(Motions, WarmIsColdAtEachStep) {
  const Method& method = *find_method("auto");
  const std::uint64_t motions = draws(10'000, 400);
  constexpr std::array families{"spheroid", "ellipsoid", "superquadric", "hard"};
  constexpr std::array ways{slide, spin, roll, shake};
  for (std::uint64_t i = 0; i < motions; ++i) {
    Motion motion(families.at(i % families.size()), i);
    const auto way = ways.at(i / families.size() % ways.size());
    Contact<double> last = method.solve(motion.pair, {}, nullptr);
    for (int step = 0; step < 200; ++step) {
      way(motion, step, last);
      const Contact<double> warm = method.solve(motion.pair, {}, &last), cold = method.solve(motion.pair, {}, nullptr);
      ASSERT_EQ(warm.status, Status::converged) << i << ", step " << step;
      ASSERT_EQ(cold.status, Status::converged) << i << ", step " << step;
      const double reach =
          std::max(size_of(motion.pair), (motion.pair.body2.position - motion.pair.body1.position).norm());
      ASSERT_NEAR(warm.overlap, cold.overlap, 1e-13 * reach) << i << ", step " << step;
      last = warm;
    }
  }
}

}  // namespace
}  // namespace plumb
