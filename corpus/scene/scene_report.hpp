// What a plan and a run are, for eyes and for programs.
#pragma once

#include <map>
#include <string>

#include "corpus/json/json_text.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {

/// The states that a run writes: the first, the last, and those between.
[[nodiscard]] std::int64_t frames_of(const Plan& plan);
/// About how many bytes they take, all outputs together: a body was measured, with two contacts each.
[[nodiscard]] double expected_bytes(const Scene& scene, const Plan& plan);
/// About how many seconds it takes: what a body and step takes in the scene `pile` on one core. Other shapes and machines differ.
[[nodiscard]] double expected_seconds(const Scene& scene, const Plan& plan);
/// "about 3 min".
[[nodiscard]] std::string time_text(double seconds);
/// "about 46 GB".
[[nodiscard]] std::string size_text(double bytes);

/// Seconds by owner, and each as a part of their sum; empty before a run.
using Seconds = std::map<std::string, double>;
[[nodiscard]] std::map<std::string, double> shares_of(const Seconds& seconds);

/// Effects with why, needs, bytes for each body and each pair of the contact list, share of time; then contacts, turning, broad
/// phase and time step with their reasons.
[[nodiscard]] Json plan_json(const Scene& scene, const Plan& plan, const Seconds& seconds);
/// The same as a table.
[[nodiscard]] std::string plan_table(const Scene& scene, const Plan& plan, const Seconds& seconds);

/// The pairs that overlap, or the contacts with their numbers, a line each.
[[nodiscard]] std::string contacts_table(const Simulation& run);

}  // namespace plumb::scene
