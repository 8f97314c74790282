// The option --accuracy of the commands that judge.
#pragma once

#include <string>

#include "corpus/command/command_line.hpp"
#include "properties/laws/accuracy.hpp"

namespace plumb {

inline constexpr const char* kAccuracyHelp = "normal=ANGLE,overlap=RATIO,points=RATIO (1e-6rad, 0.01deg; of the size), "
                                             "or a level: rounding, 1e-6rad, 0.01deg, 1deg; "
                                             "findings are what is worse";

/// `text` is read by parse_accuracy().
inline void declare_accuracy(CommandLine& app, std::string& text) {
  app.add_option("--accuracy", text, kAccuracyHelp)->capture_default_str();
}

/// The same of kept cases, read by accuracy_instead().
inline void declare_accuracy_of_cases(CommandLine& app, std::string& text) {
  app.add_option("--accuracy", text, std::string(kAccuracyHelp) + " (default: that of the case, or rounding)");
}

/// " --accuracy TEXT" for a command that is printed; nothing for rounding, which needs none.
[[nodiscard]] inline std::string accuracy_option(const std::string& text) {
  return text == "rounding" ? "" : " --accuracy " + text;
}

}  // namespace plumb
