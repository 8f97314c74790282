// What the targets of layout contact-1 have in common: decode, ask, screen; what is suspected goes to the certified judgement
// (examine_pair.hpp), and nothing else is a finding.
#pragma once

#include <functional>

#include "fuzz/layouts/decode_contact.hpp"
#include "fuzz/targets/target.hpp"

namespace plumb {

/// The solver of target_settings.hpp, screened with the directions that come with the layout: ten thousands of answers a second.
[[nodiscard]] Outcome examine_contact(const BuiltContact& built, std::span<const std::uint8_t> bytes,
                                      const char* target);

/// `auto` asked in several ways (properties/doors/agreement.hpp), with the normals of every other method as witnesses against it.
[[nodiscard]] Outcome examine_agreement(const BuiltContact& built, std::span<const std::uint8_t> bytes,
                                        std::span<const struct AgreementLaw> laws, const char* target);

}  // namespace plumb
