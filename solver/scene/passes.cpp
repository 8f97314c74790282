#include "solver/scene/passes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace plumb::scene {
namespace {

void clear_forces(World& world) {
  world.state.force->fill(0);
  if (world.state.torque != nullptr) world.state.torque->fill(0);
  for (Column* column : {world.contacts.normal_force, world.contacts.stiffness, world.contacts.force})
    if (column != nullptr) column->fill(0);
}

/// What contacts remember, of those that have ended.
void forget(const Contacts& contacts, std::vector<Column*>& histories) {
  for (Column* column : histories)
    for (const std::uint32_t c : contacts.parted) std::ranges::fill(column->entry(c), column->kind().initial);
}

/// The elastic and cohesive forces along the normals, onto the bodies.
void push_along_normals(World& world) {
  for (const std::uint32_t c : world.contacts.touching) world.push_along_normal(c, (*world.contacts.normal_force)[c]);
}

}  // namespace

void run_all(std::vector<Pass>& passes) {
  for (Pass& pass : passes) {
    const auto start = std::chrono::steady_clock::now();
    pass.run();
    pass.spent += std::chrono::steady_clock::now() - start;
  }
}

void append(std::vector<Pass>& passes, std::vector<Pass> more) {
  std::ranges::move(more, std::back_inserter(passes));
}

std::vector<Pass> take_contact_passes(World& world, const Plan& plan) {
  std::vector<Pass> passes;
  std::vector<Column*> histories;
  for (Column& column : world.columns)
    if (column.kind().forgets) histories.push_back(&column);
  if (!histories.empty())
    passes.push_back({"contacts", [&world, histories]() mutable { forget(world.contacts, histories); }});
  passes.push_back({"motion", [&world] { clear_forces(world); }});
  append(passes, std::exchange(world.contact_passes, {}));
  if (plan.needs.normal_force) passes.push_back({"contacts", [&world] { push_along_normals(world); }});
  return passes;
}

std::vector<Pass> take_closing_passes(World& world) {
  std::vector<Pass> passes = std::exchange(world.body_passes, {});
  append(passes, std::exchange(world.closing_passes, {}));
  return passes;
}

}  // namespace plumb::scene
