// A reference as JSON and back without loss.
#pragma once

#include "corpus/json/fields.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {

/// All of it but the cover and the nearest points, the proof. Reals of 50 digits are MPFR's hexadecimal text
/// ("0x1.8p+0"), doubles their shortest decimals; what is not finite is the word inf, -inf or nan.
[[nodiscard]] Json reference_json(const Reference& reference);

/// The same bits again, without these. Throws FieldError.
[[nodiscard]] Reference read_reference(const Field& field);

/// The same of one answer.
[[nodiscard]] Json solution_json(const Solution& solution);
[[nodiscard]] Solution read_solution(const Field& field);

[[nodiscard]] Json ring_json(const Ring& ring);

}  // namespace plumb
