// The words for superellipsoids that LAMMPS has since 30Mar2026, in those of the LAMMPS that Debian 12 packs and of plumb's styles.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::lammps {

/// Of the fix that has exponents and densities: it is there once atom_style ellipsoid superellipsoid was asked for.
inline constexpr const char* superellipsoids_fix = "plumb_superellipsoids";

/// The commands that make that fix.
[[nodiscard]] std::vector<std::string> shapes_of_superellipsoids();

/// The commands to do in the place of one; none: it stays as it is. `has_superellipsoids`: whether that fix is there.
[[nodiscard]] std::vector<std::string> in_older_words(std::string_view command, std::span<const std::string> words,
                                                      bool has_superellipsoids);

}  // namespace plumb::lammps
