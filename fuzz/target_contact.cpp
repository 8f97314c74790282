// Bytes -> contact -> the pair around it -> answer -> screen: layout contact-1, tens of thousands of answers a second. What the
// screen suspects is judged by all laws and the certified reference, and nothing else is a finding.
#include <fmt/format.h>

#include <array>
#include <exception>

#include "fuzz/decode_contact.hpp"
#include "fuzz/examine_pair.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/target_settings.hpp"
#include "fuzz/thermometer.hpp"
#include "properties/screen.hpp"

namespace plumb {
namespace {

Screening screen_answer(const BuiltContact& built) {
  const Contact<double> answer = target_settings().solver.solve(built.pair, Want{}, nullptr);
  const Vec3<double> line = built.pair.body2.position - built.pair.body1.position;
  const std::array<Vec3<double>, 2> witnesses{built.normal, line.isZero() ? built.normal : line.stableNormalized()};
  const Screening found = screen(built.pair, answer, witnesses);
  light(found);
  light(answer);
  return found;
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const BuiltContact built = decode_contact(bytes);
  try {
    const Screening found = screen_answer(built);
    if (!(found.worst > 1)) return {false, "none suspected"};
  } catch (const std::exception&) {  // examine_pair meets it again, and names it
  }
  return examine_pair(contact_case(built, bytes), "fuzz-contact");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
