// The families of random cases, written once: the campaign, the RapidCheck generators and the test suite draw from here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case/case.hpp"

namespace plumb {

class Stream;
struct Draft;
struct HardGenerator;

/// A row of family_rows.inc: all that is known of a family. It is drawn by one function, or case after case by the generators of a table.
struct Family {
  std::string_view name;
  std::string_view summary;
  void (*draw)(Stream&, Draft&);
  std::span<const HardGenerator> (*generators)();  ///< nullptr: none, and no ladders
  double per_minute;                               ///< cases that ./fuzz/run draws in a minute
  std::uint64_t gated;                             ///< cases of reports/gate
};
[[nodiscard]] std::span<const Family> families();
[[nodiscard]] std::vector<std::string> family_names();
/// nullptr where there is none of that name.
[[nodiscard]] const Family* find_family(std::string_view name);

/// The names of the generators of the family `hard`, one for each special place.
[[nodiscard]] std::vector<std::string_view> hard_generators();

/// Case `index` of a family under a seed: same arguments, same case, on any machine with the same math library.
[[nodiscard]] Case generate(std::string_view family, std::uint64_t seed, std::uint64_t index);

/// One named generator of the hard family; how hard is drawn as well, between the steps of its ladder or on one.
[[nodiscard]] Case generate_hard(std::string_view generator, std::uint64_t seed, std::uint64_t index);

/// The ladder of a hard generator: the values of what it steers, the easiest first. A case has it in provenance: "knob": { "name", "value" }.
[[nodiscard]] std::span<const double> ladder_steps(std::string_view generator);
/// The same random numbers as generate_hard's, on a step of the ladder: 0 .. ladder_steps().size() - 1.
[[nodiscard]] Case ladder_case(std::string_view generator, std::size_t step, std::uint64_t seed, std::uint64_t index);
/// The step that a value is nearest to, on a logarithmic scale.
[[nodiscard]] std::size_t step_of(std::string_view generator, double knob);

/// Simpler cases in order of preference (equal bodies, spheres before spheroids before triaxial, whole exponents, round
/// angles, short decimals); all legal, none equal to the case itself. The expectations are dropped, the provenance says
/// "simplified". Taking one after the other ends: each lowers a whole-number cost.
[[nodiscard]] std::vector<Case> simpler(const Case& c);

}  // namespace plumb
