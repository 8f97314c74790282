// As target_contact.cpp, of ellipsoids alone, whose answers take a microsecond: layout ellipsoid-1.
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_contact.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_contact(decode_contact(bytes, ContactShapes::ellipsoids), bytes, "fuzz-ellipsoid");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
