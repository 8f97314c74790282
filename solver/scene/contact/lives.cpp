#include "solver/scene/contact/lives.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace plumb::scene {
namespace {

/// What an entry holds; overlaps are 0 before there was one.
enum Number { begun, before, now, deepest, force_before, force_now, strongest, width };

/// The vertex of the parabola through three steps, where the middle one is the greatest.
double peak(double first, double middle, double last) {
  const double bend = 2 * middle - first - last;
  if (middle < first || middle < last || bend <= 0) return middle;
  return middle + (first - last) * (first - last) / (8 * bend);
}

/// Part of a step from an overlap to where there is none, by the line through the next one inwards; a half where that tells nothing.
double part_of_step(double outer, double inner) {
  return inner > outer ? std::min(1.0, outer / (inner - outer)) : 0.5;
}

void follow(std::span<double> life, double overlap, double force, const World& world) {
  const bool is_new = life[now] == 0, is_second = !is_new && life[before] == 0;
  if (is_new) life[begun] = std::max(0.0, world.time - world.time_step / 2);
  if (is_second && life[begun] > 0) life[begun] = world.time - world.time_step * (1 + part_of_step(life[now], overlap));
  life[deepest] = std::max(life[deepest], overlap);
  life[strongest] = is_new ? force : std::max(life[strongest], force);
  if (!is_new && !is_second) {
    life[deepest] = std::max(life[deepest], peak(life[before], life[now], overlap));
    life[strongest] = std::max(life[strongest], peak(life[force_before], life[force_now], force));
  }
  life[before] = life[now];
  life[now] = overlap;
  life[force_before] = life[force_now];
  life[force_now] = force;
}

Life life_of(const World& world, std::uint32_t contact, double end) {
  const auto life = std::as_const(*world.contacts.life).entry(contact);
  const auto [i, j] = world.contacts.pairs[contact];
  Life out;
  out.body1 = i;
  out.body2 = j;
  out.start = life[begun];
  out.duration = end - life[begun];
  out.greatest_overlap = life[deepest];
  if (world.contacts.normal_force != nullptr) out.greatest_force = life[strongest];
  return out;
}

}  // namespace

Column& add_lives(World& world) {
  return world.columns.add("life", "lives", history(width));
}

void follow_lives(World& world) {
  const Contacts& contacts = world.contacts;
  for (const std::uint32_t c : contacts.pressing)
    follow(contacts.life->entry(c), (*contacts.overlap)[c],
           contacts.normal_force == nullptr ? 0 : (*contacts.normal_force)[c], world);
}

std::vector<Life> ended_lives(const World& world) {
  std::vector<Life> out;
  for (const std::uint32_t c : world.contacts.parted) {
    const auto life = std::as_const(*world.contacts.life).entry(c);
    const double last = world.time - world.time_step;
    out.push_back(life_of(world, c, last + world.time_step * part_of_step(life[now], life[before])));
    out.back().has_ended = true;
  }
  return out;
}

std::vector<Life> lasting_lives(const World& world) {
  std::vector<Life> out;
  for (const std::uint32_t c : world.contacts.pressing) out.push_back(life_of(world, c, world.time));
  return out;
}

}  // namespace plumb::scene
