#include "reports/bench/bench_sets.hpp"

#include <algorithm>
#include <array>

#include "corpus/command/interrupt.hpp"
#include "corpus/json/nearest_word.hpp"
#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"

namespace plumb::reports {
namespace {

/// Two equal bodies, as in a run of one particle type.
Case draw_whole(std::uint64_t seed, std::uint64_t index) {
  constexpr std::array exponents{2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  Stream stream("whole", seed, index);
  const auto any = [&] { return stream.pick(exponents); };
  Draft draft;
  Superellipsoid<double> shape = random_ellipsoid(stream, 5);
  shape.n1 = any();
  shape.n2 = any();
  draft.pair.body1 = {shape, Vec3<double>::Zero(), random_rotation(stream)};
  draft.pair.body2 = {shape, Vec3<double>::Zero(), random_rotation(stream)};
  place_on_random_line(stream, draft, stream.log_uniform(1e-3, 5e-2));
  return {"whole", draft.pair, {}, draft.facts, {}};
}

constexpr std::array<PairSet, 6> kSets{{
    {"spheroid", "spheroids, aspect 1/3..3", "spheroid", 0, 2},
    {"ellipsoid", "triaxial ellipsoids, aspect to 20", "ellipsoid", 0, 2},
    {"exponents-8", "exponents 2..8, aspect to 5", "superquadric", 2, 8},
    {"whole", "two equal bodies, exponents of 2, 2.5, 3, 4, 5, 6, 8, 10, aspect to 5", "", 0, 10, false, draw_whole},
    {"exponents-40", "exponents 2..40, one at least above 8, aspect to 5", "superquadric", 8, 40},
    {"hard", "the family hard", "hard", 0, 0, true},
}};

bool has_usual_overlap(const Case& c) {
  constexpr double least = 1e-3, greatest = 5e-2;
  if (c.provenance.contains("placement")) return false;  // the ratio is not what it says: see place_at_ratio
  const double ratio = c.provenance.at("overlap_ratio").get<double>();
  return ratio >= least && ratio <= greatest;
}

bool has_exponents(const Pair& pair, double above, double upto) {
  const Superellipsoid<double>&s1 = pair.body1.shape, &s2 = pair.body2.shape;
  const auto [least, greatest] = std::minmax({s1.n1, s1.n2, s2.n1, s2.n2});
  return least >= 2 && greatest > above && greatest <= upto;
}

bool belongs(const Case& c, const PairSet& set) {
  return set.takes_all || (has_usual_overlap(c) && has_exponents(c.pair, set.above, set.upto));
}

const PairSet& find_set(std::span<const PairSet> sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const PairSet& set) { return set.name == name; });
  if (found != sets.end()) return *found;
  std::vector<std::string> known;
  for (const PairSet& set : sets) known.emplace_back(set.name);
  throw InputFailure("--set", 0, name, no_such("set", name, known));
}

}  // namespace

std::span<const PairSet> sets_with_hard() {
  return kSets;
}

std::span<const PairSet> pair_sets() {
  return sets_with_hard().first(kSets.size() - 1);
}

std::vector<PairSet> find_sets(std::span<const PairSet> sets, const std::vector<std::string>& names) {
  if (names.empty()) return {sets.begin(), sets.end()};
  std::vector<PairSet> out;
  for (const std::string& name : names) out.push_back(find_set(sets, name));
  return out;
}

std::vector<Case> draw(const PairSet& set, std::size_t count, std::uint64_t seed) {
  std::vector<Case> cases;
  for (std::uint64_t i = 0; cases.size() < count && !interrupted(); ++i) {
    Case c = set.draw == nullptr ? generate(set.family, seed, i) : set.draw(seed, i);
    if (belongs(c, set)) cases.push_back(std::move(c));
  }
  return cases;
}

Pair moved(const Pair& pair, std::uint64_t seed, std::uint64_t index) {
  constexpr double step = 1e-3;
  Stream stream("moved", seed, index);
  const Vec3<double> axis = random_direction(stream), shift = random_direction(stream);
  Pair out = pair;
  out.body2.quaternion = product(turn(axis, step), pair.body2.quaternion);
  out.body2.position += step * size_of(pair) * shift;
  return out;
}

std::vector<Pair> motion(const Pair& pair, double step, std::uint64_t seed, std::uint64_t index) {
  constexpr int steps = 60;
  Stream stream("motion", seed, index);
  const Vec3<double> line = (pair.body2.position - pair.body1.position).stableNormalized();
  const Quaternion turned = turn(random_direction(stream), step);
  const Vec3<double> any = random_direction(stream), slide = (any - any.dot(line) * line).stableNormalized();
  std::vector<Pair> out{pair};
  for (int k = 0; k < steps; ++k) {
    Pair next = out.back();
    next.body2.quaternion = product(turned, next.body2.quaternion);
    next.body2.position += step * size_of(pair) * slide;
    out.push_back(next);
  }
  return out;
}

}  // namespace plumb::reports
