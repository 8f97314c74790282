// The arcs that a surface point is made of, against their definition in 50 digits, and their steps against the direction that
// they should arrive at.
#include "solver/method/auto/surface/surfaces.hpp"

#include <gtest/gtest.h>

#include <array>

#include "properties/generators/stream.hpp"
#include "solver/reference/real.hpp"

namespace plumb::arc_tests {
namespace {

using Fine = Real50;
template <class S>
using Arc = SuperellipseArc<S>;

constexpr std::array exponents{1.1, 1.5, 1.9, 2.0, 2 + 1e-9, 2.5, 8.0, 50.0};

template <class S>
struct Plane {
  S a, b;
};

/// Body 1's of a point.
template <class S>
Plane<S> c_of(const ArcPoint<S>& at) {
  return {first<S>(at.ca), first<S>(at.cb)};
}
template <class S>
Plane<S> g_of(const ArcPoint<S>& at) {
  return {first<S>(at.ga), first<S>(at.gb)};
}

template <class S>
ArcPoint<S> arc_at(const Arc<S>& arc, const Plane<S>& v, bool is_g) {
  return arc_point_at<S>(arc, PerBody<S>(v.a), PerBody<S>(v.b), Mask<S>(is_g));
}

/// Each component from 1e-30 to 1, of either sign.
Plane<double> draw_plane(Stream& stream) {
  Plane<double> out{stream.sign(), stream.chance(0.5) ? stream.uniform(-1, 1) : stream.signed_log_uniform(1e-30, 1)};
  if (stream.chance(0.5)) std::swap(out.a, out.b);
  return out;
}

/// Body 1 has the exponent, body 2 another.
template <class S>
Arc<S> arc_of(double n) {
  return arc_of_exponents<S>(per_body<S>(S(n), S(3.5)));
}

Fine plain_power(const Fine& x, const Fine& e) {
  return (x < 0 ? Fine(-pow(Fine(-x), e)) : Fine(pow(x, e)));
}

template <class Test>
void for_each_arc(std::string_view name, int points, Test test) {
  Stream stream(name, 1, 0);
  for (const double n : exponents)
    for (int k = 0; k < points; ++k) {
      SCOPED_TRACE(testing::Message() << "exponent " << n << ", draw " << k);
      test(n, stream);
      if (testing::Test::HasFailure()) return;
    }
}

TEST(SuperellipseArc, IsTheUnitCurveWithItsGradientAndCurvature) {
  for_each_arc("definition", 20, [](double n, Stream& stream) {
    const Arc<Fine> arc = arc_of<Fine>(n);
    const Plane<double> v = draw_plane(stream);
    const ArcPoint<Fine> at = arc_at<Fine>(arc, {Fine(v.a), Fine(v.b)}, false);
    const Fine nu = n < 2 ? Fine(Fine(n) / (Fine(n) - 1)) : Fine(n);
    const auto [ca, cb] = c_of(at);
    EXPECT_LE(abs(Fine(ca / cb / (Fine(v.a) / Fine(v.b)) - 1)), Fine("1e-46"));
    EXPECT_GE(ca * v.a, 0);
    EXPECT_LE(abs(Fine(pow(abs(ca), nu) + pow(abs(cb), nu) - 1)), Fine("1e-46"));
    const auto near = [&](const PerBody<Fine>& found, const Fine& truth) {
      // As far as a power of e^-690 is kept.
      if (abs(truth) > Fine("1e-290")) {
        EXPECT_LE(abs(Fine(first<Fine>(found) / truth - 1)), Fine("1e-43"));
      }
    };
    near(at.ga, plain_power(ca, nu - 1));
    near(at.gb, plain_power(cb, nu - 1));
    near(at.ka, (nu - 1) * pow(abs(ca), nu - 2));
    near(at.kb, (nu - 1) * pow(abs(cb), nu - 2));
  });
}

/// Whole exponents of both bodies are taken by products, where the point is not told by its gradient.
TEST(SuperellipseArc, WholeExponentsAreTheSamePowers) {
  for (int n = 3; n <= 10; ++n) {
    const Arc<double> arc = arc_of_exponents<double>(PerBody<double>(n));
    Arc<double> general = arc;
    general.multiplied = 0;
    EXPECT_EQ(arc.multiplied, n - 1);
    Stream stream("whole exponents", static_cast<std::uint64_t>(n), 0);
    for (int k = 0; k < 200; ++k) {
      const Plane<double> v = draw_plane(stream);
      SCOPED_TRACE(testing::Message() << "exponent " << n << ", at " << v.a << ", " << v.b);
      const ArcPoint<double> at = arc_at<double>(arc, v, false), plain = arc_at<double>(general, v, false);
      const Fine ratio = Fine(v.a) / Fine(v.b), larger = pow(Fine(1 + pow(abs(ratio), n)), Fine(-1) / n);
      const Fine ga = pow(Fine(abs(ratio) * larger), n - 1);
      EXPECT_LE(abs(Fine(abs(Fine(first<double>(at.cb))) / larger - 1)), 4 * epsilon<double>());
      if (ga > Fine("1e-290")) {
        EXPECT_LE(abs(Fine(abs(Fine(first<double>(at.ga))) / ga - 1)), 12 * epsilon<double>());
        // exp's argument is rounded.
        const double noise = (8 + std::abs(std::log(first<double>(at.u)))) * epsilon<double>();
        EXPECT_NEAR(first<double>(at.ga) / first<double>(plain.ga), 1, noise);
        EXPECT_NEAR(first<double>(at.kb) / first<double>(plain.kb), 1, noise);
      }
    }
  }
  EXPECT_EQ(arc_of_exponents<double>(PerBody<double>(11)).multiplied, 0);
  EXPECT_EQ(arc_of_exponents<double>(PerBody<double>(2.5)).multiplied, 0);
  EXPECT_EQ(arc_of_exponents<double>(per_body<double>(3, 4)).multiplied, 0);
}

/// |g| has the dual norm 1, so that an exponent below 2 has its points there.
TEST(SuperellipseArc, GradientsLieOnTheDualCurve) {
  for_each_arc("dual", 20, [](double n, Stream& stream) {
    const Arc<Fine> arc = arc_of<Fine>(n);
    const Plane<double> v = draw_plane(stream);
    const ArcPoint<Fine> at = arc_at<Fine>(arc, {Fine(v.a), Fine(v.b)}, true);
    const auto [ga, gb] = g_of(at);
    const auto [ca, cb] = c_of(at);
    const Fine nu = first<Fine>(arc.nu), mu = nu / (nu - 1);
    EXPECT_EQ(first<Fine>(arc.nu) == Fine(n), n >= 2);
    if (n < 2) {
      EXPECT_LE(abs(Fine(mu - Fine(n))), Fine("1e-45"));
    }
    EXPECT_LE(abs(Fine(ga / gb / (Fine(v.a) / Fine(v.b)) - 1)), Fine("1e-43"));
    EXPECT_LE(abs(Fine(pow(abs(ga), mu) + pow(abs(gb), mu) - 1)), Fine("1e-43"));
    EXPECT_LE(abs(Fine(ca * ga + cb * gb - 1)), Fine("1e-46"));
  });
}

TEST(SuperellipseArc, InDoubleItIsRightToRounding) {
  for_each_arc("rounding", 200, [](double n, Stream& stream) {
    const Plane<double> v = draw_plane(stream);
    const bool is_g = stream.chance(0.5);
    const ArcPoint<double> ours = arc_at<double>(arc_of<double>(n), v, is_g);
    const ArcPoint<Fine> truth = arc_at<Fine>(arc_of<Fine>(n), {Fine(v.a), Fine(v.b)}, is_g);
    const auto near = [&](const PerBody<double>& found, const PerBody<Fine>& exact) {
      const auto expected = static_cast<double>(first<Fine>(exact));
      if (std::abs(expected) > 1e-200 && std::abs(expected) < 1e200) {
        EXPECT_NEAR(first<double>(found), expected, 2e-13 * std::abs(expected));  // a power's logarithm: 460 epsilon
      }
    };
    near(ours.ca, truth.ca), near(ours.cb, truth.cb), near(ours.ga, truth.ga), near(ours.gb, truth.gb);
    near(ours.ka, truth.ka), near(ours.kb, truth.kb), near(ours.t, truth.t), near(ours.u, truth.u);
  });
}

/// The head of the file: dc = (-gb, ga), dg = (-ka gb, kb ga).
TEST(SuperellipseArc, TheTangentIsTheCurvesDifference) {
  for_each_arc("tangent", 10, [](double n, Stream& stream) {
    const Arc<Fine> arc = arc_of<Fine>(n);
    const Plane<double> v{stream.sign() * stream.uniform(0.05, 1), stream.sign() * stream.uniform(0.05, 1)};
    const ArcPoint<Fine> at = arc_at<Fine>(arc, {Fine(v.a), Fine(v.b)}, false);
    const auto [ca, cb] = c_of(at);
    const auto [ga, gb] = g_of(at);
    const Fine step("1e-17");
    const auto beside = [&](const Fine& h) { return arc_at<Fine>(arc, {ca - h * gb, cb + h * ga}, false); };
    const ArcPoint<Fine> ahead = beside(step), behind = beside(-step);
    const auto slope = [&](const PerBody<Fine>& above, const PerBody<Fine>& below) -> Fine {
      return (first<Fine>(above) - first<Fine>(below)) / (2 * step);
    };
    const Fine ka = first<Fine>(at.ka), kb = first<Fine>(at.kb), allowed = Fine("1e-24") * (1 + ka + kb);
    EXPECT_LE(abs(Fine(slope(ahead.ca, behind.ca) + gb)), allowed);
    EXPECT_LE(abs(Fine(slope(ahead.cb, behind.cb) - ga)), allowed);
    EXPECT_LE(abs(Fine(slope(ahead.ga, behind.ga) + ka * gb)), allowed);
    EXPECT_LE(abs(Fine(slope(ahead.gb, behind.gb) - kb * ga)), allowed);
  });
}

/// t* where du/dt = 1.
TEST(SuperellipseArc, TheStepChangesItsVariableWhereBothAreAsSteep) {
  for (const double n : exponents) {
    const Arc<double> arc = arc_of<double>(n);
    const double t = first<double>(arc.switch_t), u = first<double>(arc.switch_u), nu = first<double>(arc.nu);
    if (nu == 2) {
      EXPECT_EQ(t, 0);
      continue;
    }
    EXPECT_NEAR((nu - 1) * std::pow(t, nu - 2), 1, 1e-8) << n;
    EXPECT_NEAR(u, std::pow(t, nu - 1), 1e-8) << n;
    EXPECT_GT(t, 0.3) << n;
    EXPECT_LT(t, 1) << n;
  }
}

template <class S>
Plane<S> along_tangent(const Plane<S>& from, const Plane<S>& by, const S& step) {
  return {S(from.a + step * by.a), S(from.b + step * by.b)};
}

/// By a tangential step; `follows_c`: in c alone.
template <class S>
ArcPoint<S> stepped(const Arc<S>& arc, const ArcPoint<S>& at, const S& step, bool follows_c) {
  const auto [ga, gb] = g_of(at);
  const Plane<S> dc{S(-gb), ga}, dg{S(-first<S>(at.ka) * gb), S(first<S>(at.kb) * ga)};
  const Plane<S> c = along_tangent(c_of(at), dc, step), g = along_tangent(g_of(at), dg, step);
  const PerBody<S> switch_t = follows_c ? PerBody<S>(std::numeric_limits<S>::infinity()) : arc.switch_t;
  return moved_arc_point<S>(arc, switch_t, at, PerBody<S>(c.a), PerBody<S>(c.b), PerBody<S>(g.a), PerBody<S>(g.b));
}

/// In c alone a step of any length, over folds and over the diagonal, is the point in that direction.
TEST(SuperellipseArc, AStepInCArrivesWhereItPoints) {
  int over_a_fold = 0, over_the_diagonal = 0;
  for_each_arc("steps", 100, [&](double n, Stream& stream) {
    const Arc<double> arc = arc_of<double>(n);
    const ArcPoint<double> at = arc_at<double>(arc, draw_plane(stream), stream.chance(0.5));
    const double step = stream.signed_log_uniform(1e-6, 1);
    const auto [ga, gb] = g_of(at);
    const Plane<double> to = along_tangent(c_of(at), {-gb, ga}, step);
    const bool b_larger = at.b_is_larger[0];
    const double larger = b_larger ? to.b * first<double>(at.sign_b) : to.a * first<double>(at.sign_a);
    if (larger < 0.1 * std::abs(b_larger ? to.a : to.b)) return;  // such steps are cut
    const ArcPoint<double> moved = stepped<double>(arc, at, step, true), expected = arc_at<double>(arc, to, false);
    const auto near = [](const PerBody<double>& a, const PerBody<double>& b) {
      EXPECT_NEAR(first<double>(a), first<double>(b), 1e-12 * std::abs(first<double>(b)) + 1e-100);
    };
    near(moved.ca, expected.ca), near(moved.cb, expected.cb), near(moved.ga, expected.ga), near(moved.gb, expected.gb);
    over_a_fold += c_of(at).a * to.a < 0 || c_of(at).b * to.b < 0 ? 1 : 0;
    over_the_diagonal += at.b_is_larger[0] != moved.b_is_larger[0] ? 1 : 0;
  });
  EXPECT_GT(over_a_fold, 50);
  EXPECT_GT(over_the_diagonal, 20);
}

/// A step follows the tangent but for its square, also where it changes from t to u, over folds and over the diagonal.
TEST(SuperellipseArc, ShortStepsFollowTheTangent) {
  int over = 0, by_u = 0;
  for_each_arc("short", 60, [&](double n, Stream& stream) {
    const Arc<Fine> arc = arc_of<Fine>(n);
    const Fine step = Fine("1e-15") * stream.sign();
    // At the change of variable, on a fold, beside the diagonal, anywhere.
    const double t_star = static_cast<double>(first<Fine>(arc.switch_t)), off = 1 + stream.uniform(-1, 1) * 1e-15;
    const std::array<double, 4> ratios{t_star * off, stream.uniform(-1, 1) * 1e-15, off, stream.uniform(0, 1)};
    Plane<double> v{stream.sign(), stream.sign() * stream.pick(ratios)};
    if (stream.chance(0.5)) std::swap(v.a, v.b);
    const ArcPoint<Fine> at = arc_at<Fine>(arc, {Fine(v.a), Fine(v.b)}, false);
    const ArcPoint<Fine> moved = stepped<Fine>(arc, at, step, false);
    const auto [ga, gb] = g_of(at);
    const Plane<Fine> to = along_tangent<Fine>(c_of(at), {Fine(-gb), ga}, step);
    const Plane<Fine> found = c_of(moved);
    // nu^2 of the second derivative, nu = 50 at most; just above 2 the limit stands for t*, to (nu - 2)^2.
    const Fine off_two = first<Fine>(arc.nu) - 2, of_limit = off_two < Fine(1e-6) ? Fine(off_two * off_two) : Fine(0);
    const Fine allowed = 1000 * step * step + of_limit;
    // In u the point moves by that over du/dt, which is 1 or more.
    EXPECT_LE(abs(Fine(found.a - to.a)), allowed);
    EXPECT_LE(abs(Fine(found.b - to.b)), allowed);
    by_u += first<Fine>(at.t) >= first<Fine>(arc.switch_t) ? 1 : 0;
    over += at.b_is_larger.a != moved.b_is_larger.a || first<Fine>(at.sign_b) != first<Fine>(moved.sign_b) ||
                    first<Fine>(at.sign_a) != first<Fine>(moved.sign_a)
                ? 1
                : 0;
  });
  EXPECT_GT(over, 20);
  EXPECT_GT(by_u, 50);
}

/// Beyond t* the variable is u: a step in g arrives where g points, however blocky the body.
TEST(SuperellipseArc, AStepInGArrivesWhereItPoints) {
  int moved_far = 0;
  for_each_arc("steps in g", 100, [&](double n, Stream& stream) {
    const Arc<double> arc = arc_of<double>(n);
    const double u_star = first<double>(arc.switch_u);
    const Plane<double> from{1, stream.uniform(u_star, 1)}, to{1, stream.uniform(u_star, 1)};
    const ArcPoint<double> at = arc_at<double>(arc, from, true);
    if (first<double>(at.t) < first<double>(arc.switch_t)) return;
    const PerBody<double> nowhere(7.0);  // c is not looked at
    const ArcPoint<double> moved =
        moved_arc_point<double>(arc, arc.switch_t, at, nowhere, nowhere, PerBody<double>(to.a), PerBody<double>(to.b));
    const ArcPoint<double> expected = arc_at<double>(arc, to, true);
    EXPECT_NEAR(first<double>(moved.ca), first<double>(expected.ca), 1e-13);
    EXPECT_NEAR(first<double>(moved.cb), first<double>(expected.cb), 1e-13);
    EXPECT_NEAR(first<double>(moved.gb), first<double>(expected.gb), 1e-13);
    moved_far += std::abs(to.b - from.b) > 0.1 ? 1 : 0;
  });
  EXPECT_GT(moved_far, 50);
}

TEST(SuperellipseArc, CappedIsRounderAndNothingElse) {
  const Arc<double> arc = arc_of_exponents<double>(per_body<double>(40.0, 1.3));
  const Arc<double> cut = capped<double>(arc, 6.0), same = capped<double>(arc, 50.0);
  EXPECT_EQ(first<double>(cut.nu), 6);
  EXPECT_EQ(second<double>(cut.nu), second<double>(arc.nu));
  EXPECT_NEAR(second<double>(cut.nu), 1.3 / 0.3, 1e-14);
  EXPECT_FALSE(cut.dual[0]);
  EXPECT_TRUE(cut.dual[1]);
  EXPECT_EQ(first<double>(same.nu), 40);
}

/// A zero component keeps its powers finite, and the half turn turns point and gradient.
TEST(SuperellipseArc, OnAFoldAllIsFinite) {
  for (const double n : exponents)
    for (const bool is_g : {false, true}) {
      const Arc<double> arc = arc_of<double>(n);
      ArcPoint<double> at = arc_at<double>(arc, {0.0, -2.0}, is_g);
      EXPECT_NEAR(first<double>(at.cb), -1, 1e-15);
      EXPECT_NEAR(first<double>(at.gb), -1, 1e-15);
      EXPECT_LE(std::abs(first<double>(at.ca)) + std::abs(first<double>(at.ga)), 1e-13);
      EXPECT_TRUE(std::isfinite(first<double>(at.ka)) && std::isfinite(first<double>(at.kb)));
      turn_round<double>(at, PerBody<double>(-1.0));
      EXPECT_NEAR(first<double>(at.cb), 1, 1e-15);
      EXPECT_NEAR(first<double>(at.gb), 1, 1e-15);
      EXPECT_EQ(first<double>(at.sign_b), 1);
    }
}

}  // namespace
}  // namespace plumb::arc_tests
