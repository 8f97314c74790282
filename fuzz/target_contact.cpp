// Bytes -> contact -> the pair around it -> answer -> screen: layout contact-1, tens of thousands of answers a second. What the
// screen suspects is judged by all laws and the certified reference, and nothing else is a finding.
#include <array>
#include <exception>
#include <string_view>

#include "fuzz/decode_contact.hpp"
#include "fuzz/examine_pair.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/target_settings.hpp"
#include "fuzz/thermometer.hpp"
#include "properties/screen.hpp"

namespace plumb {
namespace {

Screening screen_answer(const BuiltContact& built, const Contact<double>& answer) {
  const Vec3<double> line = built.pair.body2.position - built.pair.body1.position;
  const std::array<Vec3<double>, 2> witnesses{built.normal, line.isZero() ? built.normal : line.stableNormalized()};
  const Screening found = screen(built.pair, answer, witnesses);
  light(found);
  light(answer);
  return found;
}

/// A certificate is what the pairs without an answer cost most, and it says nothing of a solver that says so itself.
bool is_let_pass(const Contact<double>& answer) {
  return answer.status != Status::converged && answer.status != Status::not_finite &&
         !target_settings().rule.stops(FindingKind::nonconverged);
}

/// Empty when there is nothing to judge.
std::string_view unsuspected(const BuiltContact& built) {
  const Contact<double> answer = target_settings().solver.solve(built.pair, Want{}, nullptr);
  const Screening found = screen_answer(built, answer);
  if (is_let_pass(answer)) return name(answer.status);
  return found.worst > 1 ? "" : "none suspected";
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const BuiltContact built = decode_contact(bytes);
  try {
    const std::string_view said = unsuspected(built);
    if (!said.empty()) return {false, std::string(said)};
  } catch (const std::exception&) {  // examine_pair meets it again, and names it
  }
  return examine_pair(contact_case(built, bytes), "fuzz-contact");
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
