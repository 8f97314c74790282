#include "reports/study/groups.hpp"

#include <algorithm>
#include <optional>

#include "corpus/command/interrupt.hpp"

namespace plumb::reports {
namespace {

constexpr std::array all_fails{Fails::signs, Fails::z, Fails::both, Fails::nothing};
constexpr int most_draws = 3000;

/// Whole multiples of 5 degrees, round aspects and exponents.
Bed draw(BedShape shape, std::uint64_t seed, int index) {
  Stream random(shape == BedShape::spheroid ? "study_spheroid" : "study_superquadric", seed,
                static_cast<std::uint64_t>(index));
  const auto angle = [&](std::size_t least, std::size_t most) {
    return 5.0 * static_cast<double>(least + random.below(most - least + 1));
  };
  Bed out;
  out.aspect = random.pick(std::array{0.5, 0.75, 1.5, 2.0, 2.5, 3.0});
  out.theta_L = angle(1, 17);
  out.euler[1] = angle(1, 35);
  if (shape == BedShape::spheroid) return out;
  out.n1 = random.pick(std::array{2.0, 2.5, 3.0, 4.0});
  out.n2 = random.pick(std::array{2.5, 3.0, 4.0, 6.0});
  out.euler[2] = angle(1, 17);
  return out;
}

std::optional<Fails> fails_of_original(const Pair& pair) {
  const Contact<double> c = find_method("original_cn")->solve(pair, {}, nullptr);
  if (c.status != Status::converged) return std::nullopt;
  return fails_of(diagnose(pair, c.point1, c.point2, 1));
}

/// The one way in which it fails at all ratios, where there is one.
std::optional<Fails> fails_always(const Bed& bed) {
  std::optional<Fails> out;
  for (const double ratio : ratios) {
    const std::optional<Fails> here = fails_of_original(pair_of(bed, ratio));
    if (!here || (out && *here != *out)) return std::nullopt;
    out = here;
  }
  return out;
}

std::vector<GroupAnswer> answers_to(const Bed& bed) {
  std::vector<GroupAnswer> out;
  for (const double ratio : ratios) {
    const Pair pair = pair_of(bed, ratio);
    const CertifiedNormal truth = certified_normal(pair);
    for (const std::string_view method : studied())
      out.push_back({ratio, method, truth.proved, study(method, pair, truth)});
  }
  return out;
}

}  // namespace

std::vector<Group> find_groups(BedShape shape, std::uint64_t seed) {
  std::vector<Group> out;
  for (const Fails fails : all_fails) {
    const char letter = shape == BedShape::spheroid ? 'G' : 'S';
    out.push_back({letter + std::to_string(out.size() + 1), fails, {}, 0, {}});
  }
  for (int i = 0; i < most_draws && !interrupted(); ++i) {
    const Bed bed = draw(shape, seed, i);
    const std::optional<Fails> fails = fails_always(bed);
    if (!fails) continue;
    Group& group = out[static_cast<std::size_t>(*fails)];
    if (group.drawn > 0) continue;
    group.bed = bed;
    group.drawn = i + 1;
    group.answers = answers_to(bed);
    if (std::all_of(out.begin(), out.end(), [](const Group& g) { return g.drawn > 0; })) break;
  }
  return out;
}

}  // namespace plumb::reports
