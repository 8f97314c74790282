// A frame of a dump of particles (LAMMPS dump custom, LIGGGHTS), as read. Which column means what: corpus/formats/dumps.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/contact.hpp"

namespace plumb {

/// Whose words the columns are: they differ in what shapex is.
enum class DumpFormat {
  by_columns,
  lammps,   ///< shapex, shapey, shapez are diameters
  liggghts  ///< shapex, shapey, shapez are semi-axes
};

/// A cell of space and where it repeats itself.
struct DumpBox {
  Vec3<double> origin = Vec3<double>::Zero();
  Mat3<double> edges = Mat3<double>::Identity();  ///< a column each
  std::array<bool, 3> is_periodic{};              ///< along the edges

  [[nodiscard]] bool repeats() const { return is_periodic[0] || is_periodic[1] || is_periodic[2]; }
};

struct DumpParticle {
  std::int64_t id = 0;
  Body body;
};

struct DumpFrame {
  std::int64_t step = 0;
  std::optional<double> time;
  std::string units;  ///< LAMMPS's unit style; empty where the file does not say
  DumpFormat format = DumpFormat::lammps;
  DumpBox box;
  std::vector<DumpParticle> particles;  ///< by rising id
  std::size_t points = 0;               ///< particles without extent, left out
};

}  // namespace plumb
