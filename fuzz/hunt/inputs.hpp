// What the hunt draws: inputs of the layouts pair-1 and contact-1, and the pair that each is, fitted to what a solver takes.
#pragma once

#include <cstdint>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/solvers/abilities.hpp"
#include "fuzz/layouts/mutate.hpp"

namespace plumb::hunting {

struct Input {
  const Layout* layout = nullptr;
  std::vector<std::uint8_t> bytes;
};

/// The layouts whose pairs can be made ones that the solver takes.
[[nodiscard]] std::vector<const Layout*> layouts_for(const Abilities& abilities);

/// Any bytes.
[[nodiscard]] Input drawn(const std::vector<const Layout*>& layouts, Stream& stream);

/// Bodies in the unit of their size, one of them in the origin: what fails only far from there is looked for later.
void bring_home(Input& input);

/// Shapes that the solver does not take become ones that it does, as far as that is possible; Abilities::takes tells.
[[nodiscard]] Case case_of(const Input& input, const Abilities& abilities);

}  // namespace plumb::hunting
