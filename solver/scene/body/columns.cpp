#include "solver/scene/body/columns.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb::scene {

const Column* Columns::find(std::string_view name) const {
  const auto found = std::ranges::find(columns_, name, &Column::name);
  return found == columns_.end() ? nullptr : &*found;
}

Column* Columns::find(std::string_view name) {
  return const_cast<Column*>(std::as_const(*this).find(name));  // NOLINT: the constness is the caller's
}

void Columns::renew(ColumnKind::Of of, std::size_t entries) {
  for (Column& column : columns_)
    if (column.kind().of == of) column.renew(entries);
}

std::uint64_t hash_of(std::span<const double> values, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const double value : values) {
    const double one = value == 0 ? 0 : (std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value);
    auto bits = std::bit_cast<std::uint64_t>(one);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8U) hash = (hash ^ (bits & 0xffU)) * 0x100000001b3U;
  }
  return hash;
}

}  // namespace plumb::scene
