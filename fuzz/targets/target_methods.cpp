// Method against method and question against question: the normals of all methods bound the overlap of `auto`, and its own answer
// must not depend on how it is asked. Layout contact-1.
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_contact.hpp"
#include "properties/doors/agreement.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_agreement(decode_contact(bytes), bytes, question_laws(), "fuzz-methods");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
