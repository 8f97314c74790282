#include "solver/reference/convex/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/reference/frame.hpp"

namespace plumb::reference::cores {
namespace {

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of w.v, lengths being of order 1

Points points_of(const std::vector<Atom>& atoms) {
  Points out;
  for (const Atom& atom : atoms) out.push_back(atom.w);
  return out;
}

/// Leaves out atoms without weight.
void keep_used(std::vector<Atom>& atoms, std::vector<double>& weights) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    atoms[kept] = atoms[i];
    weights[kept++] = weights[i];
  }
  atoms.resize(kept);
  weights.resize(kept);
}

Vec3<double> direction_of(const std::array<double, 4>& weights, const CornersOfCell& corners) {
  Vec3<double> out = Vec3<double>::Zero();
  for (std::size_t j = 0; j < corners.size(); ++j) out += weights[j] * corners[j];
  return out;
}

CornersOfCell cell_about(const Vec3<double>& n, double half) {
  const Mat3<double> frame = frame_about(n);
  CornersOfCell out;
  for (std::size_t j = 0; j < out.size(); ++j)
    out[j] = (frame * Vec3<double>(j % 2 == 0 ? half : -half, j / 2 == 0 ? half : -half, 1)).normalized();
  return out;
}

/// Goes on in the direction of a step while that leads lower.
LowDirection extended(const PlacedCores& pair, const Vec3<double>& from, LowDirection best) {
  constexpr int doublings = 12;
  const Vec3<double> step = best.n - from;
  double length = 2;
  for (int k = 0; k < doublings; ++k, length *= 2) {
    const LowDirection next = along(pair, from + length * step);
    if (!(next.overlap < best.overlap)) break;
    best = next;
  }
  return best;
}

}  // namespace

LowDirection along(const PlacedCores& pair, const Vec3<double>& v) {
  const Vec3<double> n = v.normalized();
  return {n, pair.farthest(n).w.dot(n)};
}

Vec3<double> mixed(const Mixture& mixture) {
  return mixed(points_of(mixture.atoms), mixture.weights);
}

Mixture mixture_in(const PlacedCores& pair, const CornersOfCell& corners, std::vector<Atom> start, const Enough& enough,
                   LowDirection& lowest) {
  constexpr int rounds = 16;
  Vec3<double> toward = corners[0] + corners[1] + corners[2] + corners[3];
  Mixture out{std::move(start), {}, -infinity};
  for (int k = 0; k < rounds; ++k) {
    const Atom atom = pair.farthest(toward);
    const double reach = atom.w.dot(toward), length = toward.norm();
    if (reach < lowest.overlap * length) lowest = {toward / length, reach / length};
    if (k > 0 && !(reach - out.value > std::max(0.1 * (enough.level - reach), rounding))) break;
    out.atoms.push_back(atom);
    GameSolution game = best_mixture(points_of(out.atoms), corners);
    out.value = game.value;
    out.weights = std::move(game.weights);
    keep_used(out.atoms, out.weights);
    if (out.value >= enough.value) break;
    toward = direction_of(game.corner_weights, corners);
  }
  return out;
}

Mixture nearest_point(const PlacedCores& pair) {
  return nearest_point_from(
      pair, {{pair.farthest(-pair.rough_centre() + Vec3<double>(0, 0, std::numeric_limits<double>::min()))}, {1}, 0});
}

Mixture nearest_point_from(const PlacedCores& pair, Mixture start) {
  constexpr int rounds = 100;
  Mixture out = std::move(start);
  Vec3<double> w = mixed(out);
  for (int k = 0; k < rounds && w.squaredNorm() > 0; ++k) {
    const Atom atom = pair.farthest(-w);
    if (!(w.squaredNorm() - atom.w.dot(w) > rounding * w.norm())) break;
    Mixture next = out;
    next.atoms.push_back(atom);
    next.weights = nearest_mixture(points_of(next.atoms));
    if (next.weights.empty()) break;
    keep_used(next.atoms, next.weights);
    const Vec3<double> nearer = mixed(next);
    if (!(nearer.squaredNorm() < w.squaredNorm())) break;
    out = std::move(next);
    w = nearer;
    if (out.atoms.size() == 4) break;
  }
  return out;
}

Mixture nearest_on_face(const PlacedCores& pair, const Vec3<double>& n) {
  constexpr int rounds = 40;
  // What is lower by more than the first is of another face, but for points so near to each other that rounding hides it: of a sliver's face
  // all corners are as high.
  constexpr std::array asides{0x1p-44, 0x1p-32, 0x1p-20, 0x1p-8};
  const auto across = [&](const Vec3<double>& w) { return Vec3<double>(w - w.dot(n) * n); };
  // Of a mixture of two what is along their line is rounding, and of a sliver's line more than what is across it.
  const auto outward = [&](const Mixture& mixture, const Vec3<double>& w) {
    if (mixture.atoms.size() != 2) return w;
    const Vec3<double> line = across(mixture.atoms[1].w - mixture.atoms[0].w);
    return Vec3<double>(w - w.dot(line) / line.squaredNorm() * line);
  };
  Mixture out{{pair.farthest(n)}, {1}, 0};
  const double top = out.atoms[0].w.dot(n);
  Vec3<double> w = across(out.atoms[0].w);
  for (const double aside : asides)
    for (int k = 0; k < rounds && w.norm() > rounding && out.atoms.size() < 4; ++k) {
      const Atom atom = pair.farthest(n - aside * outward(out, w).normalized());
      if (aside > asides[0] && !(top - atom.w.dot(n) <= rounding)) break;
      Mixture next = out;
      next.atoms.push_back(atom);
      Points flat = points_of(next.atoms);
      for (Vec3<double>& point : flat) point = across(point);
      next.weights = nearest_mixture(flat);
      if (next.weights.empty()) break;
      keep_used(next.atoms, next.weights);
      const Vec3<double> nearer = across(mixed(next));
      if (!(nearer.norm() < w.norm())) break;
      out = std::move(next);
      w = nearer;
    }
  return out;
}

Descent descend(const PlacedCores& pair, const Vec3<double>& from) {
  constexpr int steps = 60;
  constexpr double first_half = 0.25, last_half = 1e-7;
  Descent out{along(pair, from), {}};
  double half = first_half;
  for (int k = 0; k < steps && half > last_half; ++k) {
    const Vec3<double> n = out.lowest.n;
    LowDirection best = out.lowest;
    out.mixture = mixture_in(pair, cell_about(n, half), {}, {infinity, -infinity}, best);
    const bool is_lower = best.overlap < out.lowest.overlap - rounding;
    if (is_lower) out.lowest = extended(pair, n, best);
    if (!is_lower || (out.lowest.n - n).norm() < half / 4) half /= 4;
  }
  return out;
}

}  // namespace plumb::reference::cores
