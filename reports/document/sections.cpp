#include "reports/document/sections.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "corpus/case/case.hpp"
#include "corpus/json/escaped.hpp"
#include "reports/document/json_lines.hpp"
#include "reports/document/schema.hpp"

namespace plumb::reports {
namespace {

/// Lines of one kind: the array that they fill, of the section or of one of its elements.
struct Kind {
  std::string name, array;
  const Json* element;
  const Json* group = nullptr;  ///< whose array it is, where it is not the section's
  std::string groups;           ///< the array of these
};

void add_kinds(const Json& description, const Json* group, const std::string& groups, std::vector<Kind>& out) {
  for (const auto& [name, property] : description["properties"].items()) {
    const Json* element = elements_of_lines(property);
    if (element == nullptr) continue;
    if (element->contains("x-kind")) out.push_back({(*element)["x-kind"], name, element, group, groups});
    if (group == nullptr) add_kinds(*element, element, name, out);
  }
}

/// 2 and 2.0 are one number.
Json comparable(const Json& value) {
  return value.is_number() ? Json(value.get<double>()) : value;
}

class SectionReader {
 public:
  explicit SectionReader(const Section& section) : section_(section), description_(definition(section.definition)) {
    add_kinds(description_, nullptr, "", kinds_);
  }

  void take(const Field& line) {
    const Field kind = line.member("kind");
    const std::string word = kind.text();
    if (ended_) kind.fail("comes after the line of kind interrupted");
    if (word == "run" && begun_) kind.fail("'run' is there twice");
    if (word == "run")
      take_run(line);
    else if (word == "interrupted")
      take_end(line);
    else
      take_kind(kind, line);
    if (!begun_) kind.fail("'" + word + "' comes before the line of kind run");
  }

  [[nodiscard]] bool is_empty() const { return known_.empty(); }
  [[nodiscard]] Json document() {
    if (section_.complete != nullptr) section_.complete(out_);
    return std::move(out_);
  }

 private:
  void take_run(const Field& line) {
    begun_ = true;
    out_ = read(description_, line);
    if (out_.contains("interrupted")) out_["interrupted"] = false;
    if (out_.contains("without")) out_["without"] = Json::array();
    finish("run", out_, line);
  }

  void take_end(const Field& line) {
    ended_ = true;
    if (out_.contains("interrupted")) out_["interrupted"] = true;
    if (out_.contains("without"))
      for (const Field& name : line.member("without").elements()) out_["without"].push_back(name.text());
  }

  void take_kind(const Field& kind, const Field& line) {
    std::string names = "run";
    for (const Kind& known : kinds_) {
      if (kind.text() == known.name) {
        if (!take_reason(known.name, line)) take_element(known, line);
        return refuse_twice(known, line);
      }
      names += ", " + known.name;
    }
    kind.fail("'" + kind.text() + "' is none of " + names + ", interrupted");
  }

  /// What has a reason in the place of its figures.
  bool take_reason(const std::string& kind, const Field& line) {
    if (!line.has("reason")) return false;
    for (const auto& [name, property] : description_["properties"].items()) {
      const Json* element = elements_of_lines(property);
      if (element == nullptr || !element->contains("x-instead")) continue;
      const Json& kinds = (*element)["properties"]["kind"]["enum"];
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
      out_[name].push_back(read(*element, line));
      return true;
    }
    return false;
  }

  void take_element(const Kind& kind, const Field& line) {
    Json& array = kind.group == nullptr ? out_[kind.array] : group_of(kind, line)[kind.array];
    Json made = read(*kind.element, line);
    finish(kind.name, made, line);
    array.push_back(std::move(made));
  }

  /// The element that the line belongs to: of a line before it or, if it has no line of its own, of the first that names it.
  Json& group_of(const Kind& kind, const Field& line) {
    const Json& group = *kind.group;
    Json& groups = out_[kind.groups];
    const bool is_made_here = !group.contains("x-kind");
    const Json own = is_made_here ? read(group, line) : Json();
    const auto known = known_.find(key_of(kind.groups, group, line));
    if (known == known_.end() && !is_made_here) refuse_unknown(group, line);
    if (known == known_.end()) {
      known_.emplace(key_of(kind.groups, group, line), groups.size());
      groups.push_back(own);
      return groups.back();
    }
    Json& found = groups[known->second];
    if (is_made_here) refuse_another(group, found, own, line);
    return found;
  }

  [[noreturn]] static void refuse_unknown(const Json& group, const Field& line) {
    const Field key = line.member(group["x-key"].back().get<std::string>());
    key.fail(group.value("x-unknown", "'" + key.text() + "' is of no line before this one"));
  }

  static void refuse_another(const Json& group, const Json& found, const Json& own, const Field& line) {
    for (const auto& [name, property] : group["properties"].items())
      if (elements_of_lines(property) == nullptr && found[name] != own[name])
        field_at(line, pointer_of(name, property))
            .fail("is " + own[name].dump() + ", in a line before this one " + found[name].dump());
  }

  void refuse_twice(const Kind& kind, const Field& line) {
    const Json& key = (*kind.element)["x-key"];
    const std::size_t place = kind.group == nullptr ? out_[kind.array].size() - 1 : 0;  // asked for of groups alone
    if (known_.emplace(key_of(kind.array, *kind.element, line), place).second) return;
    std::string others;
    for (std::size_t i = 0; i + 1 < key.size(); ++i) others += (i == 0 ? ", of " : " and ") + key[i].get<std::string>();
    line.member(key.back().get<std::string>()).fail("is there twice" + others);
  }

  static std::string key_of(std::string array, const Json& element, const Field& line) {
    for (const Json& name : element["x-key"])
      array += " " + comparable(line.member(name.get<std::string>()).value()).dump();
    return array;
  }

  [[nodiscard]] Json read(const Json& description, const Field& line) const {
    return read_line(description, line, [this](const std::string& kind, const Field& key) {
      return std::any_of(kinds_.begin(), kinds_.end(), [&](const Kind& known) {
        return known.name == kind && known_.contains(known.array + " " + key.value().dump());
      });
    });
  }

  void finish(const std::string& kind, Json& made, const Field& line) {
    for (const KindRule& rule : section_.rules)
      if (kind == rule.kind) rule.finish(out_, made, line);
  }

  const Section& section_;
  const Json& description_;
  std::vector<Kind> kinds_;
  Json out_;
  std::map<std::string, std::size_t> known_;  ///< keys, with their places in the section's arrays
  bool begun_ = false, ended_ = false;
};

}  // namespace

const std::vector<Section>& all_sections() {
  static const std::vector<Section> all{
      {"precision", "Precision", false, {}}, stability_section(), study_section(), fem_section()};
  return all;
}

std::string source_of(const Section& section) {
  return definition(section.definition)["x-lines"]["of"];
}

Json read_section(const Section& section, const std::filesystem::path& file) {
  SectionReader reader(section);
  for_each_line(file, [&](const Field& line) { reader.take(line); });
  const Json& lines = definition(section.definition)["x-lines"];
  if (reader.is_empty())
    throw InputFailure(file.string(), 0, "",
                       "holds no " + lines["holds"].get<std::string>() + " of " + lines["of"].get<std::string>());
  return reader.document();
}

Json section_json(const std::string& name, const std::filesystem::path& file) {
  const auto& all = all_sections();
  return read_section(*std::find_if(all.begin(), all.end(), [&](const Section& s) { return s.name == name; }), file);
}

std::string shown_text(const Json& text) {
  return markdown_text(text.get<std::string>());
}

std::string incomplete_mark(const Json& section) {
  return section["interrupted"] == true ? " - INCOMPLETE" : "";
}

}  // namespace plumb::reports
