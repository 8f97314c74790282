// What an engine that looks for new coverage is to climb besides code: how near an answer is to breaking a law, and how hard the
// solver worked. A thermometer is a row of cells; a reading lights all cells up to it, and an input that lights one
// more than any before is kept. libFuzzer reads the cells as its extra counters, other engines know nothing of them.
#pragma once

#include <string_view>

#include "properties/laws/screen.hpp"

namespace plumb {

/// A thermometer for each of ScreenCheck, then the others. The stage of the fallbacks that answered is code, which an engine sees
/// by itself.
enum class Thermometer {
  first_check = 0,
  severity = static_cast<int>(screen_checks),  ///< of the certified judgement
  iterations,
  evaluations,
  backtracks,  ///< evaluations that were no iteration
  condition,   ///< of the normal: how many digits the pair itself takes
  disagreement,
  error,  ///< of a foreign solver's answer over what is asked for (hunt/guide.hpp)
  count
};

/// Lights the cells below the reading: a degree for each power of two of `value` / `lowest`, none below it, 32 at most.
void light(Thermometer thermometer, double value, double lowest);

/// The severities of a screening, from a thousandth of what is allowed on.
void light(const Screening& screening);

/// The work of an answer.
void light(const Contact<double>& answer);

/// Puts them out, as an engine does before each input.
void clear_thermometers();

/// Empty when the cells are where the engine looks for them and a reading changes them; otherwise what is wrong. An array that
/// is only written to may be dropped by a compiler, and nothing else would tell.
[[nodiscard]] std::string_view thermometer_fault();

}  // namespace plumb
