// The sections that plumb report takes over from another report's JSON lines. The schema describes them; a row here has what it cannot say.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "corpus/json/fields.hpp"

namespace plumb::reports {

/// What is made of a line beside what is read of it; throws FieldError. `section`: as the lines before have left it.
using Finish = void (*)(Json& section, Json& made, const Field& line);

/// Lines of a kind that hold more than the schema says.
struct KindRule {
  const char* kind;
  Finish finish;
};

struct Section {
  const char* name;                           ///< in the document, of the option and of the file: --NAME, NAME.jsonl
  const char* definition;                     ///< in the schema
  bool stands_alone;                          ///< a page of it needs no campaign
  std::vector<KindRule> rules;                ///< `run`: of the first line, which makes the section itself
  void (*complete)(Json& section) = nullptr;  ///< after the last line
  std::string (*markdown)(const Json& section) = nullptr;  ///< its lines in the summary
};

[[nodiscard]] const std::vector<Section>& all_sections();

/// The command whose lines they are.
[[nodiscard]] std::string source_of(const Section& section);

/// Lines of several kinds: `run` first, `interrupted` last, none twice. Throws InputFailure.
[[nodiscard]] Json read_section(const Section& section, const std::filesystem::path& file);

/// The section of this name.
[[nodiscard]] Json section_json(const std::string& name, const std::filesystem::path& file);

/// A text of the document in Markdown.
[[nodiscard]] std::string shown_text(const Json& text);

/// " - INCOMPLETE" of a section that Ctrl-C ended.
[[nodiscard]] std::string incomplete_mark(const Json& section);

[[nodiscard]] Section stability_section();
[[nodiscard]] Section study_section();
[[nodiscard]] Section fem_section();

}  // namespace plumb::reports
