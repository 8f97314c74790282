// Which columns of a dump hold what.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/dump/dump_frame.hpp"

namespace plumb {

struct DumpOptions {
  DumpFormat format = DumpFormat::by_columns;
  std::map<std::string, std::string> columns;  ///< role -> name of the column, before any that is found by its name
};

/// Places in a row, from 0.
struct DumpColumns {
  std::size_t width = 0;
  std::size_t id = 0;
  std::array<std::size_t, 3> position{};
  bool is_scaled = false;  ///< the position is in the box's edges
  std::optional<std::array<std::size_t, 3>> shape;
  std::optional<std::array<std::size_t, 2>> exponents;   ///< n1, n2
  std::optional<std::array<std::size_t, 4>> quaternion;  ///< w, x, y, z
  std::optional<std::size_t> radius;
  bool radius_is_diameter = false;
  DumpFormat format = DumpFormat::lammps;
  std::vector<std::string> notes;  ///< what was taken for what without its name saying so
};

/// The words that DumpOptions::columns knows.
[[nodiscard]] std::vector<std::string> dump_roles();

/// By the names in the line of ITEM: ATOMS. Throws FieldError.
[[nodiscard]] DumpColumns find_columns(std::span<const std::string> names, const DumpOptions& options);

}  // namespace plumb
