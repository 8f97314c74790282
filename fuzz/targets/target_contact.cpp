// Bytes -> contact -> the pair around it -> answer -> screen: layout contact-1.
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_contact.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_contact(decode_contact(bytes), bytes, "fuzz-contact");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
