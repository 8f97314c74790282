// What follows from a scene before anything has moved: bounds that the plan and the roles of effects go by.
#pragma once

#include <string_view>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

[[nodiscard]] bool can_move(const Scene& scene);

/// Whether any two bodies, or a body and a wall, can meet within the duration. False is proved: no centre leaves the ball of radius
/// (|v| + |u|) T + |g| T^2 / 2 about its start, u being the fluid's velocity, for as long as nothing touches.
[[nodiscard]] bool can_touch(const Scene& scene);

/// Bodies so far apart are contacts.
[[nodiscard]] double contact_range(const Scene& scene);

/// How many of linear, hertz, volume and foundation are asked for, and their names.
[[nodiscard]] int elastic_laws(const Scene& scene);
inline constexpr const char* names_of_elastic_laws = "linear, hertz, volume or foundation";
/// One that is not 0.
[[nodiscard]] bool has_elastic_force(const Effects& effects);
/// Throws SceneError where the scene asks for none; `effect` needs one.
void require_elastic_force(const Scene& scene, std::string_view effect, const char* why);
/// Throws SceneError where there is another than `effect`, an elastic law.
void require_one_elastic_law(const Scene& scene, std::string_view effect);
/// Of the fastest collision there can be: half a period of the linear force; of Hertz's, that of spheres (Johnson 1985, eq. 11.24) at
/// the greatest speed, or at a thousandth of the speed of sound; of a volume's or a foundation's, that of the stiffer of balls and flat faces at the
/// volume that stops the greatest speed. Infinite without such a force.
[[nodiscard]] double collision_time(const Scene& scene);

/// In which a lonely body's slip dies, m / (6 pi viscosity r), or its spin, 3/10 of that: the kicks take it as constant. Infinite
/// without drag.
[[nodiscard]] double drag_time(const Scene& scene);

/// The least mass that an impulse through a contact can feel.
[[nodiscard]] double least_contact_mass(const Scene& scene);

/// At what speed bodies and walls may meet: their first speeds, what gravity adds over the scene's height or over the duration, and
/// the wind.
[[nodiscard]] double greatest_speed(const Scene& scene);

/// The longest and the shortest semi-axis of all movable bodies.
[[nodiscard]] double longest_axis(const Scene& scene);
[[nodiscard]] double shortest_axis(const Scene& scene);

}  // namespace plumb::scene
