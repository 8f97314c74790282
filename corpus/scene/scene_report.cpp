#include "corpus/scene/scene_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "corpus/scene/scene_file.hpp"
#include "corpus/scene/scene_view.hpp"

namespace plumb::scene {
namespace {

using Memories = std::map<std::string, Memory>;

std::string_view word_of(Analysis analysis) {
  switch (analysis) {
    case Analysis::touching: return "touching";
    case Analysis::contacts: return "contacts";
    case Analysis::motion: return "motion";
  }
  return "motion";
}

std::vector<std::string> words_of(const Needs& needs) {
  std::vector<std::string> out;
  const std::array<std::pair<bool, const char*>, 5> words{{{needs.contacts, "contacts"},
                                                           {needs.points, "points"},
                                                           {needs.curvature, "curvature"},
                                                           {needs.spin, "spin"},
                                                           {needs.normal_force, "normal_force"}}};
  for (const auto& [is_needed, word] : words)
    if (is_needed) out.emplace_back(word);
  if (needs.range > 0) out.push_back("range " + shortest(needs.range));
  return out;
}

std::vector<std::string> words_of(const Plan& plan) {
  std::vector<std::string> out;
  if (!plan.needs.contacts) return out;
  const std::array<std::pair<bool, const char*>, 4> words{{{plan.want.overlap, "overlap"},
                                                           {plan.want.normal, "normal"},
                                                           {plan.want.points, "points"},
                                                           {plan.want.curvature, "curvature"}}};
  for (const auto& [is_wanted, word] : words)
    if (is_wanted) out.emplace_back(word);
  if (out.empty()) out.emplace_back("verdict");
  return out;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

Json memory_json(const Memory& memory) {
  return {{"body", memory.body}, {"pair", memory.pair}};
}

/// Owners that are no effects: what every scene of this kind pays for.
std::vector<std::string> other_owners(const Plan& plan, const Memories& memory, const Seconds& seconds) {
  std::set<std::string> owners;
  for (const auto& [owner, of_owner] : memory) owners.insert(owner);
  for (const auto& [owner, of_owner] : seconds) owners.insert(owner);
  for (const PlannedEffect& planned : plan.effects) owners.erase(std::string(planned.effect->name));
  return {owners.begin(), owners.end()};
}

struct Costs {
  Memories memory;
  std::map<std::string, double> shares;

  [[nodiscard]] Memory memory_of(const std::string& owner) const {
    const auto found = memory.find(owner);
    return found == memory.end() ? Memory{} : found->second;
  }
  [[nodiscard]] Json json_of(const std::string& owner) const {
    Json out = {{"memory", memory_json(memory_of(owner))}};
    if (const auto share = shares.find(owner); share != shares.end()) out["share"] = share->second;
    return out;
  }
  [[nodiscard]] std::string columns_of(const std::string& owner) const {
    const auto [body, pair] = memory_of(owner);
    const auto share = shares.find(owner);
    const std::string measured = share == shares.end() ? "" : fmt::format("{:5.1f} %", 100 * share->second);
    return fmt::format("{:>5} {:>5} {:>8}", body, pair, measured);
  }
};

/// Of a frame: what it takes of itself, and a body's share in the scene `pile`. Of lives nobody knows before.
struct Size {
  bool Outputs::* asked;
  double of_frame, of_body;
};
constexpr std::array<Size, 8> sizes{{{&Outputs::energy, 200, 0},
                                     {&Outputs::touching, 60, 20},
                                     {&Outputs::contacts, 60, 600},
                                     {&Outputs::dump, 300, 400},
                                     {&Outputs::vtk, 4000, 950},
                                     {&Outputs::playback, 150, 300},
                                     {&Outputs::lives, 0, 0},
                                     {&Outputs::bulk, 900, 0}}};

std::size_t turning_bodies(const Plan& plan) {
  return static_cast<std::size_t>(std::ranges::count(plan.turns, true));
}

std::string row(std::string_view name, std::string_view state, const std::string& costs, const std::string& why) {
  std::string out = fmt::format("{:<13} {:<9} {:>20}  {}", name, state, costs, why);
  out.erase(out.find_last_not_of(' ') + 1);
  return out + "\n";
}

/// Shorter runs end before one has read it.
constexpr double worth_telling = 10;

std::string heading(const Scene& scene, const Plan& plan) {
  std::string out = fmt::format("{}: {} bodies, {} walls; ", scene.name.empty() ? "scene" : scene.name,
                                scene.bodies.size(), scene.walls.size());
  if (plan.analysis == Analysis::motion) {
    out += fmt::format("{} steps of {:.6g}", plan.steps, plan.time_step);
    if (const double bytes = expected_bytes(scene, plan); bytes > 0)
      out += fmt::format("; {} frames, {}", frames_of(plan), size_text(bytes));
    if (const double seconds = expected_seconds(scene, plan); seconds >= worth_telling)
      out += fmt::format("; {} on one core", time_text(seconds));
    return out + "\n";
  }
  return out + (plan.analysis == Analysis::touching ? "which bodies touch, no motion\n" : "contacts, no motion\n");
}

std::string reasons(const Plan& plan) {
  std::string out = row("contacts", plan.needs.contacts ? "on" : "off", "", plan.contacts_why);
  out += row("turning", fmt::format("{}/{}", turning_bodies(plan), plan.turns.size()), "", plan.turning_why);
  out += row("broad phase", plan.broad_phase == BroadPhase::tree ? "tree" : "none", "", plan.broad_phase_why);
  out += row("time step", fmt::format("{:.3g}", plan.time_step), "", plan.time_step_why);
  if (!plan.needs.contacts) return out;
  return out + row("solver", "gives", "", joined(words_of(plan)) + fmt::format(", to {:.3g}", plan.want.tolerance));
}

/// The pairs of materials that can meet, and what they have of those effects that mix.
Json materials_json(const Scene& scene, const Plan& plan) {
  Json out = Json::array();
  const PairEffects& pairs = plan.pair_effects;
  for (std::size_t a = 0; a < pairs.materials; ++a)
    for (std::size_t b = a; b < pairs.materials; ++b) {
      if (pairs.meets[pairs.at(a, b)] == 0) continue;
      Json effects = effects_json(pairs.of[pairs.at(a, b)]);
      for (const Effect& effect : scene::effects())
        if (!effect.is_of_pairs) effects.erase(std::string(effect.name));
      const MaterialPair* given = given_pair(scene, a, b);
      out.push_back({{"between", {scene.materials[a].name, scene.materials[b].name}},
                     {"given", given == nullptr ? Json::object() : effects_json(given->effects)},
                     {"effects", effects}});
    }
  return out;
}

/// The first, and the others up to the last that is not as where nothing is said.
std::string numbers_of(const std::string& name, const Json& effect) {
  Effects neutral;
  find_effect(name)->ask(neutral);
  const Json unsaid = effects_json(neutral)[name];
  std::string out, rest;
  for (const auto& [field, value] : effect.items()) {
    rest += (out.empty() ? "" : " ") + fmt::format("{:.6g}", value.get<double>());
    if (out.empty() || value != unsaid[field]) out += std::exchange(rest, "");
  }
  return out;
}

std::string material_rows(const Scene& scene, const Plan& plan) {
  std::string out;
  for (const Json& pair : materials_json(scene, plan)) {
    out += pair["between"][0].get<std::string>() + " and " + pair["between"][1].get<std::string>() + ": ";
    std::vector<std::string> words;
    for (const auto& [name, effect] : pair["effects"].items())
      words.push_back(name + " " + numbers_of(name, effect) + (pair["given"].contains(name) ? " (given)" : ""));
    out += (words.empty() ? "nothing" : joined(words)) + "\n";
  }
  return out;
}

}  // namespace

std::int64_t frames_of(const Plan& plan) {
  if (plan.steps == 0) return 1;
  if (plan.steps_per_output == 0) return 2;
  return 1 + (plan.steps + plan.steps_per_output - 1) / plan.steps_per_output;
}

double expected_bytes(const Scene& scene, const Plan& plan) {
  const auto bodies = static_cast<double>(scene.bodies.size());
  double of_frame = 0;
  for (const Size& size : sizes)
    if (scene.run.outputs.*size.asked) of_frame += size.of_frame + size.of_body * bodies;
  return of_frame * static_cast<double>(frames_of(plan));
}

double expected_seconds(const Scene& scene, const Plan& plan) {
  constexpr double in_contact = 1.6e-6, alone = 3e-7;  // a body and step; alone: ellipsoids that turn
  const double of_body = plan.needs.contacts ? in_contact : alone;
  return of_body * static_cast<double>(scene.bodies.size()) * static_cast<double>(plan.steps);
}

std::string time_text(double seconds) {
  if (seconds < 60) return fmt::format("about {:.2g} s", seconds);
  if (seconds < 3600) return fmt::format("about {:.2g} min", seconds / 60);
  if (seconds < 86400) return fmt::format("about {:.2g} h", seconds / 3600);
  return fmt::format("about {:.2g} days", seconds / 86400);
}

std::string size_text(double bytes) {
  constexpr std::array<const char*, 5> units{"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return fmt::format("about {:.2g} {}", bytes, units.at(unit));
}

std::map<std::string, double> shares_of(const Seconds& seconds) {
  double sum = 0;
  for (const auto& [owner, spent] : seconds) sum += spent;
  std::map<std::string, double> out;
  if (sum <= 0) return out;
  for (const auto& [owner, spent] : seconds) out[owner] = spent / sum;
  return out;
}

Json plan_json(const Scene& scene, const Plan& plan, const Seconds& seconds) {
  const Costs costs{memory_of(scene, plan), shares_of(seconds)};
  Json effects = Json::array(), others = Json::object();
  for (const PlannedEffect& planned : plan.effects) {
    const std::string name(planned.effect->name);
    Json effect = {{"name", name}, {"on", planned.is_on}, {"why", planned.why}, {"needs", words_of(planned.needs)}};
    if (planned.is_on) effect.update(costs.json_of(name));
    effects.push_back(effect);
  }
  for (const std::string& owner : other_owners(plan, costs.memory, seconds)) others[owner] = costs.json_of(owner);
  Json out = {{"analysis", word_of(plan.analysis)},
              {"effects", effects},
              {"others", others},
              {"contacts", {{"on", plan.needs.contacts}, {"why", plan.contacts_why}}},
              {"turning", {{"bodies", turning_bodies(plan)}, {"why", plan.turning_why}}},
              {"broad_phase", {{"tree", plan.broad_phase == BroadPhase::tree}, {"why", plan.broad_phase_why}}},
              {"time_step", {{"value", plan.time_step}, {"why", plan.time_step_why}}},
              {"steps", plan.steps},
              {"steps_per_output", plan.steps_per_output},
              {"frames", frames_of(plan)},
              {"expected_bytes", expected_bytes(scene, plan)},
              {"expected_seconds", expected_seconds(scene, plan)},
              {"solver", {{"want", words_of(plan)}, {"tolerance", plan.want.tolerance}}}};
  if (!scene.materials.empty()) out["materials"] = materials_json(scene, plan);
  return out;
}

std::string plan_table(const Scene& scene, const Plan& plan, const Seconds& seconds) {
  const Costs costs{memory_of(scene, plan), shares_of(seconds)};
  std::string out = heading(scene, plan);
  out += row("effect", "", fmt::format("bytes: body  pair {}", seconds.empty() ? "" : "  time"),
             "why, and what it needs of the rest");
  for (const PlannedEffect& planned : plan.effects) {
    const std::string name(planned.effect->name);
    const std::string needs = joined(words_of(planned.needs));
    out += row(name, planned.is_on ? "on" : "off", planned.is_on ? costs.columns_of(name) : "",
               planned.why + (needs.empty() ? "" : "; needs " + needs));
  }
  for (const std::string& owner : other_owners(plan, costs.memory, seconds))
    out += row(owner, "", costs.columns_of(owner), "");
  return out + reasons(plan) + material_rows(scene, plan);
}

std::string contacts_table(const Simulation& run) {
  std::string out;
  if (run.plan().analysis == Analysis::touching) {
    const auto pairs = touching_pairs(run);
    const auto bodies = static_cast<std::uint32_t>(run.world().bodies.count);
    out = fmt::format("{} touching\n", pairs.size());
    for (const auto& [i, j] : pairs)
      out += j < bodies ? fmt::format("  {} {}\n", i, j) : fmt::format("  {} wall {}\n", i, j - bodies);
    return out;
  }
  const auto contacts = contacts_of(run);
  out = fmt::format("{} contacts: bodies, overlap, normal, point\n", contacts.size());
  for (const ContactView& c : contacts) {
    const std::string second = c.wall ? fmt::format("wall {}", *c.wall) : std::to_string(c.body2);
    out += fmt::format("  {} {}  {}  {} {} {}  {} {} {}\n", c.body1, second, c.overlap, c.normal[0], c.normal[1],
                       c.normal[2], c.point[0], c.point[1], c.point[2]);
  }
  return out;
}

}  // namespace plumb::scene
