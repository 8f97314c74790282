#include "corpus/command/command_line.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "corpus/command/help/command_rows.hpp"
#include "corpus/json/nearest_word.hpp"

namespace plumb {

CommandOption* CommandOption::required() {
  option_->required();
  return this;
}

CommandOption* CommandOption::capture_default_str() {
  option_->capture_default_str();
  return this;
}

CommandOption* CommandOption::check(const Check& refuse) {
  option_->check(refuse);
  return this;
}

CommandOption* CommandOption::in_range(std::int64_t low, std::int64_t high) {
  option_->check(CLI::Range(low, high));
  return this;
}

CommandOption* CommandOption::is_positive() {
  option_->check(CLI::PositiveNumber);
  return this;
}

CommandOption* CommandOption::is_one_of(const std::string& kind, const std::vector<std::string>& words) {
  const auto refuse = [kind, words](const std::string& word) {
    return std::ranges::find(words, word) == words.end() ? word + ": " + no_such(kind, word, words) : "";
  };
  option_->check(CLI::Validator(refuse, fmt::format("{{{}}}", fmt::join(words, ","))));
  return this;
}

CommandOption* CommandOption::delimiter(char separator) {
  option_->delimiter(separator);
  return this;
}

CommandOption* CommandOption::one_each() {
  option_->allow_extra_args(false);
  return this;
}

CommandOption* CommandOption::needs(const CommandOption* other) {
  option_->needs(other->option_);
  return this;
}

CommandOption* CommandOption::excludes(const CommandOption* other) {
  option_->excludes(other->option_);
  return this;
}

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : name_(name), app_(std::make_unique<CLI::App>(description, name)) {}

CommandLine::~CommandLine() = default;

CommandOption* CommandLine::keep(CLI::Option* option) {
  return &options_.emplace_back(option);
}

template <class Value>
CommandOption* CommandLine::add_option(const std::string& names, Value& value, const std::string& help) {
  return keep(app_->add_option(names, value, help));
}
template CommandOption* CommandLine::add_option(const std::string&, std::string&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, double&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, int&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, unsigned&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::int64_t&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::uint64_t&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::optional<double>&, const std::string&);
template CommandOption* CommandLine::add_option(const std::string&, std::vector<std::string>&, const std::string&);

CommandOption* CommandLine::add_flag(const std::string& names, bool& value, const std::string& help) {
  return keep(app_->add_flag(names, value, help));
}

/// An option that there is none of, where it is nearly one that there is: what is wrong, whatever else is.
std::optional<std::string> CommandLine::misspelt() const {
  std::vector<std::string> known;
  for (const CLI::Option* option : app_->get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& word : app_->remaining()) {
    const std::string name = word.substr(0, word.find('='));
    const std::string meant = name.starts_with("--") ? did_you_mean(name, known) : "";
    if (!meant.empty()) return name + ": no such option" + meant;
  }
  return std::nullopt;
}

// Help and version are exceptions of CLI11, too; their code is 0.
CommandLine::Parsed CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return {.go_on = true, .help = "", .error = ""};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return {.go_on = false, .help = "", .error = misspelt().value_or(error.what())};
    std::ostringstream help;
    (void)app_->exit(error, help, help);
    return {.go_on = false, .help = help.str() + examples_text(name_), .error = ""};
  }
}

}  // namespace plumb
