#include "fuzz/hunt/cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "solver/pose.hpp"

namespace plumb::hunting {
namespace {

/// How many are climbed at a time, and how often; among the others of so few the hottest, so that no kind of pair is forgotten.
constexpr std::size_t kHottest = 32, kFew = 4;
constexpr double kFromHottest = 0.5;

/// 0 .. 26: a digit a coordinate, 0, 1, 2 for below, at and above zero.
std::int16_t octant(const Pair& pair) {
  const Vec3<double> line =
      rotation<double>(pair.body1.quaternion).transpose() * (pair.body2.position - pair.body1.position);
  int out = 0;
  for (const double x : line) out = 3 * out + (x > 0 ? 2 : x < 0 ? 0 : 1);
  return static_cast<std::int16_t>(out);
}

/// A power of two of what an overlap is of the smaller body, with its sign; tenths from a tenth on.
std::int16_t depth(const Pair& pair, double overlap) {
  const double size = std::min(pair.body1.shape.semi_axes.maxCoeff(), pair.body2.shape.semi_axes.maxCoeff());
  const double ratio = std::abs(overlap) / size;
  constexpr int from_tenths = 100;  // beyond all powers of two
  if (!(ratio > 0) || !std::isfinite(ratio)) return 0;
  const int step =
      ratio < 0.1 ? std::max(-60, std::ilogb(ratio)) : from_tenths + static_cast<int>(10 * std::min(ratio, 2.0));
  return static_cast<std::int16_t>(overlap < 0 ? -200 + step : 200 + step);
}

std::int16_t equal_axes(const Superellipsoid<double>& shape) {
  const auto& a = shape.semi_axes;
  return static_cast<std::int16_t>((a[0] == a[1] ? 1 : 0) + (a[1] == a[2] ? 2 : 0) + (a[2] == a[0] ? 4 : 0));
}

/// Where an exponent is told from its neighbours by how it is solved.
std::int16_t exponent_class(double n) {
  const std::array<double, 5> ends{2, 2.5, 4, 8, 20};
  if (n == 2) return -1;
  return static_cast<std::int16_t>(std::lower_bound(ends.begin(), ends.end(), n) - ends.begin());
}

std::int16_t power_of_two(double error) {
  const double least = 1e-3;
  return static_cast<std::int16_t>(error > least ? 1 + std::ilogb(error / least) : 0);
}

}  // namespace

Cell cell_of(const Pair& pair, double overlap, const Heat& heat) {
  const auto exponents = [](const Superellipsoid<double>& shape) {
    return exponent_class(std::max(shape.n1, shape.n2));
  };
  const auto &one = pair.body1.shape, &two = pair.body2.shape;
  return {octant(pair),
          depth(pair, overlap),
          equal_axes(one),
          equal_axes(two),
          exponents(one),
          exponents(two),
          static_cast<std::int16_t>(heat.looks_like),
          power_of_two(heat.error)};
}

void Cells::add(const Cell& cell, const Input& input, double error) {
  const auto [known, is_new] = places_.try_emplace(cell, kept_.size());
  const std::size_t place = known->second;
  if (is_new)
    kept_.push_back({input, error});
  else if (error > kept_[place].error)
    kept_[place] = {input, error};
  else
    return;
  rank(place);
}

void Cells::rank(std::size_t place) {
  std::erase(hottest_, place);
  const auto colder = [&](std::size_t a, std::size_t b) { return kept_[a].error > kept_[b].error; };
  hottest_.insert(std::upper_bound(hottest_.begin(), hottest_.end(), place, colder), place);
  if (hottest_.size() > kHottest) hottest_.pop_back();
}

const Input& Cells::pick(Stream& stream) const {
  if (stream.chance(kFromHottest)) return kept_[hottest_[stream.below(hottest_.size())]].input;
  const Kept* best = &kept_[stream.below(kept_.size())];
  for (std::size_t i = 1; i < kFew; ++i) {
    const Kept& other = kept_[stream.below(kept_.size())];
    if (other.error > best->error) best = &other;
  }
  return best->input;
}

bool Cells::is_worth_a_proof(const Cell& cell) {
  return std::has_single_bit(++suspects_[cell]);
}

}  // namespace plumb::hunting
