// Every instruction set gives the same bits.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/generators/families.hpp"
#include "properties/tests/patch/special_pairs.hpp"
#include "solver/method/methods.hpp"
#include "solver/patch/caps.hpp"
#include "solver/patch/kernel.hpp"
#include "solver/patch/meridians.hpp"

namespace plumb::detail {
namespace {

std::vector<Pair> pairs() {
  std::vector<Pair> out;
  for (const auto& [name, pair] : special_pairs()) out.push_back(pair);
  for (std::uint64_t i = 0; i < 40; ++i)
    for (const char* family : {"spheroid", "ellipsoid", "superquadric", "hard"})
      out.push_back(generate(family, 7, i).pair);
  return out;
}

/// All that a kernel says of a lens.
struct Said {
  std::array<Eight, 2> exits{};
  bool has_rims = false;
  Rims rims{};
  std::optional<Halves> fans;
  Halves meridians{};
};

Said said_by(const LensKernel& kernel, const FramedLens& lens) {
  constexpr double accuracy = 1e-4;
  const Circle azimuths = circle(0.4, 0.7);
  Said out;
  Vector3<Eight> rays;
  for (std::size_t k = 0; k < eight; ++k) set(rays, k, lens.across(azimuths.cosine[k], azimuths.sine[k]).eigen());
  kernel.find_exits(lens.bodies, lens.origin, rays, eight, accuracy, out.exits);
  out.rims.rho.fill(1), out.rims.z.fill(0);
  out.has_rims = kernel.find_rims(lens, azimuths, accuracy, out.rims);
  const std::array apex{lens.origin + lens.e3, lens.origin - lens.e3};
  static constexpr GaussRule<6> rule = gauss_rule<6, 1>();
  if (out.has_rims)
    out.fans = kernel.add_fans({lens, apex, 6, rule.nodes.data(), rule.weights.data(), 1, 1.5, true}, out.rims);
  out.meridians = kernel.add_meridians(lens, azimuths, accuracy, 1, 4);
  return out;
}

template <class T>
bool same_bits(const T& a, const T& b) {
  using Bits = std::array<std::uint64_t, sizeof(T) / sizeof(double)>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

void expect_same(const Said& got, const Said& want, const std::string& of) {
  EXPECT_TRUE(same_bits(got.exits, want.exits)) << of;
  EXPECT_TRUE(same_bits(got.meridians, want.meridians)) << of;
  ASSERT_EQ(got.has_rims, want.has_rims) << of;
  if (!want.has_rims) return;
  EXPECT_TRUE(same_bits(got.rims, want.rims)) << of;
  ASSERT_EQ(got.fans.has_value(), want.fans.has_value()) << of;
  EXPECT_TRUE(same_bits(got.fans.value_or(Halves{}), want.fans.value_or(Halves{}))) << of;
}

TEST(LensKernels, HaveTheSameBits) {
  int lenses = 0, of_fans = 0;
  for (const Pair& pair : pairs()) {
    const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
    if (contact.verdict != Verdict::overlapping) continue;
    const PlacedPair<double> placed = place<double>(pair);
    const Lens lens(placed);
    const Vec3<double> middle = placed.to_pair_point(contact.contact_point, pair), inside = point_inside(lens, middle);
    if (!(lens.gauge(inside) < 1)) continue;
    const FramedLens framed(lens, lens_frame(lens, inside, contact.normal, placed.size()));
    const Said want = said_by(*lens_kernels().front(), framed);
    for (const LensKernel* kernel : lens_kernels())
      expect_same(said_by(*kernel, framed), want, "lens " + std::to_string(lenses));
    ++lenses;
    of_fans += want.fans ? 1 : 0;
  }
  EXPECT_GT(lenses, 100);
  EXPECT_GT(of_fans, 50);
}

}  // namespace
}  // namespace plumb::detail
