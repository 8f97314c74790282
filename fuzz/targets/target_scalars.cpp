// Scalar against scalar: `auto` in float and in long double against double. Layout contact-1.
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_contact.hpp"
#include "properties/doors/agreement.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_agreement(decode_contact(bytes), bytes, scalar_laws(), "fuzz-scalars");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
