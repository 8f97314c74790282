// A frame as the text of a dump: the one writer of them. Numbers are the shortest decimals that read back to the same double.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "corpus/dump/dump_frame.hpp"

namespace plumb {

/// A box around bodies.
struct DumpBounds {
  Vec3<double> low = Vec3<double>::Constant(std::numeric_limits<double>::infinity());
  Vec3<double> high = Vec3<double>::Constant(-std::numeric_limits<double>::infinity());
  std::array<bool, 3> is_periodic{};
  void include(const Vec3<double>& centre, double radius);
};

/// LAMMPS: diameters, and beside LAMMPS's own names the two by which OVITO draws superquadrics, 2/n2 and 2/n1. LIGGGHTS: semi-axes.
[[nodiscard]] std::string dump_column_names(DumpFormat format);

/// Up to the rows. `time` is no item of LIGGGHTS's; further columns follow those of dump_column_names.
[[nodiscard]] std::string dump_head(std::int64_t step, std::optional<double> time, std::size_t count,
                                    const DumpBounds& bounds, const std::string& columns);

/// The body's values for those columns, without a line feed.
void add_dump_body(std::string& text, DumpFormat format, std::size_t id, int type, const Body& body);

void add_dump_numbers(std::string& text, std::span<const double> numbers);

}  // namespace plumb
