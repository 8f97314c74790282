// Bytes -> pair -> answer -> laws: layout pair-1, every law, the certified reference. The environment is that of
// target_settings.hpp.
#include "fuzz/decode.hpp"
#include "fuzz/examine_pair.hpp"
#include "fuzz/mutate.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_pair(decode(bytes), "fuzz-pair");
}

const Layout& target_layout() {
  return pair_layout();
}

}  // namespace plumb
