// ellipsoids LIBRARY.so COUNT [triaxial]: a solver behind the C door against the common normal of overlapping ellipsoids, in long
// double and with no code of plumb's but that header. The table of reports/notes/2026-11-25-peers.md is what it prints.
//
// o(n) = h1(n) + h2(n) - n.c over unit n, h(n) = sqrt(n.S n), S = R diag(a^2) R': the lowest of Newton's ends from 40 starts.
#include <dlfcn.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "solver/plumb_solver.h"

namespace {

using Real = long double;
using Vector = std::array<Real, 3>;
using Matrix = std::array<Vector, 3>;
using Random = std::mt19937_64;

Real dot(const Vector& v, const Vector& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
Vector plus(const Vector& v, Real s, const Vector& w) {
  return {v[0] + s * w[0], v[1] + s * w[1], v[2] + s * w[2]};
}
Vector unit(const Vector& v) {
  const Real length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
Vector cross(const Vector& v, const Vector& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}
Vector times(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

Matrix shape_matrix(const plumb_body& body) {
  const double* q = body.quaternion_wxyz;
  const Real w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + x * x + y * y + z * z;
  const Matrix r{{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                  {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                  {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        out[i][j] += r[i][k] * r[j][k] / (n * n) * body.semi_axes[k] * body.semi_axes[k];
  return out;
}

struct Bodies {
  Matrix s1, s2;
  Vector line;  // from centre 1 to centre 2
};

struct Overlap {
  Real value;
  Vector slope;  // tangential to the sphere
};
Overlap overlap(const Bodies& b, const Vector& n) {
  const Vector x1 = times(b.s1, n), x2 = times(b.s2, n);
  const Real h1 = std::sqrt(dot(n, x1)), h2 = std::sqrt(dot(n, x2));
  const Vector gradient = plus(plus(plus({}, 1 / h1, x1), 1 / h2, x2), -1, b.line);
  const Real value = h1 + h2 - dot(n, b.line);
  return {value, plus(gradient, -value, n)};
}

struct Lowest {
  Real overlap;
  Vector normal;
};

/// Newton's step in the tangent plane, by differences of the slope; downhill where that has no minimum.
Vector step_at(const Bodies& b, const Vector& n, const Vector& slope) {
  constexpr Real d = 1e-6L, downhill = 0.5L;
  const Vector e1 = unit(cross(n, std::fabs(n[0]) < 0.7L ? Vector{1, 0, 0} : Vector{0, 1, 0})), e2 = cross(n, e1);
  const auto across = [&](const Vector& e) {
    const Vector ahead = overlap(b, unit(plus(n, d, e))).slope, behind = overlap(b, unit(plus(n, -d, e))).slope;
    return plus(plus({}, 1 / (2 * d), ahead), -1 / (2 * d), behind);
  };
  const Vector along1 = across(e1), along2 = across(e2);
  const Real h11 = dot(along1, e1), h12 = (dot(along1, e2) + dot(along2, e1)) / 2, h22 = dot(along2, e2);
  const Real determinant = h11 * h22 - h12 * h12, g1 = dot(slope, e1), g2 = dot(slope, e2);
  if (!(determinant > 0 && h11 + h22 > 0)) return plus({}, -downhill / std::sqrt(dot(slope, slope)), slope);
  return plus(plus({}, -(h22 * g1 - h12 * g2) / determinant, e1), -(h11 * g2 - h12 * g1) / determinant, e2);
}

Lowest descend(const Bodies& b, Vector n) {
  Overlap here = overlap(b, n);
  for (int iteration = 0; iteration < 300 && dot(here.slope, here.slope) > 1e-34L; ++iteration) {
    const Vector step = step_at(b, n, here.slope);
    Real share = 1;
    Vector there = unit(plus(n, share, step));
    Overlap next = overlap(b, there);
    while (next.value > here.value + 1e-18L && share > 1e-12L) {
      share /= 2;
      there = unit(plus(n, share, step));
      next = overlap(b, there);
    }
    if (next.value > here.value + 1e-18L) break;
    n = there;
    here = next;
  }
  return {here.value, n};
}

Lowest lowest(const Bodies& b) {
  constexpr int starts = 40;
  Lowest best = descend(b, unit(b.line));
  for (int i = 0; i < starts; ++i) {
    const Real z = (2 * i + 1.0L) / starts - 1, r = std::sqrt(1 - z * z);
    const Lowest found = descend(b, {r * std::cos(2.4L * i), r * std::sin(2.4L * i), z});
    if (found.overlap < best.overlap) best = found;
  }
  return best;
}

/// Aspects from 1/3 to 3, both turned, in contact along a random line to an overlap ratio from 0.001 to 0.05.
plumb_pair draw(Random& random, bool triaxial) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  plumb_pair pair{};
  for (plumb_body& body : pair.bodies) {
    for (int i = 0; i < 3; ++i) body.semi_axes[i] = triaxial || i == 2 ? std::pow(3.0, 2 * uniform(random) - 1) : 1;
    body.exponents[0] = body.exponents[1] = 2;
    for (double& x : body.quaternion_wxyz) x = normal(random);
  }
  const Vector u = unit({normal(random), normal(random), normal(random)});
  Bodies bodies{shape_matrix(pair.bodies[0]), shape_matrix(pair.bodies[1]), {}};
  Real near = 0, far = 8;  // beyond any touch
  for (int i = 0; i < 40; ++i) {
    const Real middle = (near + far) / 2;
    bodies.line = plus({}, middle, u);
    (descend(bodies, u).overlap > 0 ? near : far) = middle;
  }
  const double ratio = 1e-3 * std::pow(50.0, uniform(random));
  for (std::size_t i = 0; i < 3; ++i) pair.bodies[1].position[i] = static_cast<double>(near * (1 - ratio) * u[i]);
  return pair;
}

struct Tally {
  int asked = 0, answered = 0, to_1e_6_rad = 0, to_hundredth_degree = 0, to_degree = 0, overlap_to_1e_6 = 0;
  Real worst = 0;  // radians
};

void judge(const plumb_pair& pair, const plumb_contact& answer, Tally& tally) {
  const Real degree = std::acos(-1.0L) / 180;
  ++tally.asked;
  if (answer.status != PLUMB_CONVERGED) return;
  ++tally.answered;
  const double* x = pair.bodies[1].position;
  const Lowest expected = lowest({shape_matrix(pair.bodies[0]), shape_matrix(pair.bodies[1]), {x[0], x[1], x[2]}});
  const Vector n{answer.normal[0], answer.normal[1], answer.normal[2]}, sine = cross(n, expected.normal);
  const Real angle = std::atan2(std::sqrt(dot(sine, sine)), dot(n, expected.normal));
  tally.to_1e_6_rad += angle < 1e-6L ? 1 : 0;
  tally.to_hundredth_degree += angle < degree / 100 ? 1 : 0;
  tally.to_degree += angle < degree ? 1 : 0;
  tally.overlap_to_1e_6 += std::fabs(answer.overlap - expected.overlap) < 1e-6L ? 1 : 0;
  tally.worst = std::max(tally.worst, angle / degree);
}

}  // namespace

int main(int count, char** words) {
  void* library = count < 3 ? nullptr : dlopen(words[1], RTLD_NOW);
  const auto solve = library == nullptr
                         ? nullptr
                         : reinterpret_cast<decltype(&plumb_solver_solve)>(dlsym(library, "plumb_solver_solve"));
  if (solve == nullptr) {
    std::fprintf(stderr, "ellipsoids LIBRARY.so COUNT [triaxial]: %s\n", count < 3 ? "words are missing" : dlerror());
    return 2;
  }
  Random random(7);
  Tally tally;
  for (int i = 0; i < std::atoi(words[2]); ++i) {
    const plumb_pair pair = draw(random, count > 3);
    plumb_contact answer{};
    answer.status = PLUMB_STALLED;
    if (solve(&pair, &answer) != 0) answer.status = PLUMB_INVALID_INPUT;
    judge(pair, answer, tally);
  }
  const auto share = [&](int part) { return 100.0 * part / tally.asked; };
  std::printf("%s: answered %.1f %%, normal to 1e-6 rad %.1f, 0.01 degree %.1f, 1 degree %.1f, worst %.3Lg degrees, "
              "overlap to 1e-6 %.1f\n",
              words[1], share(tally.answered), share(tally.to_1e_6_rad), share(tally.to_hundredth_degree),
              share(tally.to_degree), tally.worst, share(tally.overlap_to_1e_6));
}
