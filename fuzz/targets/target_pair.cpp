// Bytes -> pair -> answer -> laws: layout pair-1, every law, the certified reference. The environment is that of
// target_settings.hpp.
#include "fuzz/layouts/decode.hpp"
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_pair.hpp"

namespace plumb {

Outcome examine(std::span<const std::uint8_t> bytes) {
  return examine_pair(decode(bytes), "fuzz-pair");
}

const Layout& target_layout() {
  return pair_layout();
}

}  // namespace plumb
