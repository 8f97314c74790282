// Numbers of many digits as decimal text, with a rounding that is known.
#pragma once

#include <string>

#include "solver/reference/real.hpp"

namespace plumb {

enum class Rounding { down, nearest, up };

/// `digits` significant digits, "1.25e-01"; "inf" and "nan" as printf has them.
[[nodiscard]] std::string decimal(const Real50& x, int digits, Rounding rounding);

/// The number that a text spells, rounded to 50 digits; NaN where the text is not all one finite decimal number.
[[nodiscard]] Real50 read_decimal(const std::string& text, Rounding rounding);

}  // namespace plumb
