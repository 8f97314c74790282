// The arguments that a command takes: declared here, parsed by CLI11. Only command_line.cpp reads CLI11's headers: compiling what
// they define takes three seconds, and there are some forty commands.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace plumb {

/// One argument; each function says one thing more about it and returns it again.
class CommandOption {
 public:
  /// What is wrong with a text, empty when nothing is.
  using Check = std::function<std::string(const std::string&)>;

  explicit CommandOption(CLI::Option* option) : option_(option) {}
  CommandOption* required();
  /// Help shows the value that it has before parsing.
  CommandOption* capture_default_str();
  CommandOption* check(const Check& refuse);
  CommandOption* in_range(std::int64_t low, std::int64_t high);
  CommandOption* is_positive();
  /// `kind`: what the words name, for the refusal.
  CommandOption* is_one_of(const std::string& kind, const std::vector<std::string>& words);
  /// Splits each text there.
  CommandOption* delimiter(char separator);
  /// Of a list: one text each time that the option is given.
  CommandOption* one_each();
  CommandOption* needs(const CommandOption* other);
  CommandOption* excludes(const CommandOption* other);

 private:
  CLI::Option* option_;
};

class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& name);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  /// `names`: "NAME" for one without a flag, "--name", "-n,--name". Value: std::string, double, int, unsigned, std::int64_t,
  /// std::uint64_t, std::optional<double>, std::vector<std::string>; it and the option live as long as this.
  template <class Value>
  CommandOption* add_option(const std::string& names, Value& value, const std::string& help = "");
  CommandOption* add_flag(const std::string& names, bool& value, const std::string& help);

  struct Parsed {
    bool go_on = false;  ///< the values are there
    std::string help;    ///< that was asked for, where it is not empty
    std::string error;
  };
  [[nodiscard]] Parsed parse(int argc, char** argv);
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  CommandOption* keep(CLI::Option* option);
  [[nodiscard]] std::optional<std::string> misspelt() const;

  std::string name_;
  std::unique_ptr<CLI::App> app_;
  std::deque<CommandOption> options_;  ///< whose addresses stay
};

}  // namespace plumb
