// What outputs read of a run.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "corpus/json/json_text.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {

/// Two bodies, or a body and a wall; NaN and nullopt where the plan asks for no such thing.
struct ContactView {
  std::uint32_t body1 = 0, body2 = 0;  ///< body 2 of a wall: the number of bodies and the wall's own
  std::optional<std::uint32_t> wall;
  double overlap = 0;
  Vec3<double> normal, point;
  std::optional<double> force;              ///< along the normal
  std::optional<Vec3<double>> total_force;  ///< on body 2, friction and dashpots too
};

/// Those that touch or are within the range of a force, in the order of the contact list.
[[nodiscard]] std::vector<ContactView> contacts_of(const Simulation& run);
/// Those of them that overlap, as pairs; a wall as in ContactView.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> touching_pairs(const Simulation& run);

/// {"bodies": [i, j]} or {"body": i, "wall": k}, and the rest of it.
[[nodiscard]] Json contact_json(const ContactView& contact);
/// {"time", "step", "contacts": [..]}
[[nodiscard]] Json contacts_json(const Simulation& run);
/// {"time", "step", "touching": [[i, j], ..], "walls": [[i, k], ..]}
[[nodiscard]] Json touching_json(const Simulation& run);

/// {"bodies" or "body" and "wall", "start", "duration", "greatest_overlap", "greatest_force", "ended"}
[[nodiscard]] Json life_json(const Simulation& run, const Life& life);

/// {"time", "step", "energy": energies_of()}
[[nodiscard]] Json energy_json(const Simulation& run);
/// energy() and its sum, "total"; empty where nothing moves.
[[nodiscard]] std::map<std::string, double> energies_of(const Simulation& run);
/// 16 hex digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace plumb::scene
