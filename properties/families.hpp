// The families of random cases, written once: the campaign, the RapidCheck generators and the test suite draw from here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.hpp"

namespace plumb {

struct Family {
  std::string_view name;  ///< spheroid, ellipsoid, superquadric, hard
  std::string_view summary;
};
[[nodiscard]] std::span<const Family> families();

/// The names of the generators of the family `hard`, one for each special place.
[[nodiscard]] std::vector<std::string_view> hard_generators();

/// Case `index` of a family under a seed: same arguments, same case, on any machine with the same math library.
[[nodiscard]] Case generate(std::string_view family, std::uint64_t seed, std::uint64_t index);

/// One named generator of the hard family.
[[nodiscard]] Case generate_hard(std::string_view generator, std::uint64_t seed, std::uint64_t index);

/// Simpler cases in order of preference (equal bodies, spheres before spheroids before triaxial, whole exponents, round
/// angles, short decimals); all legal, none equal to the case itself. The expectations are dropped, the provenance says
/// "simplified". Taking one after the other ends: each lowers a whole-number cost.
[[nodiscard]] std::vector<Case> simpler(const Case& c);

}  // namespace plumb
