#include "reports/document/kinds_of_line.hpp"

#include <set>
#include <string>
#include <utility>

#include "corpus/case/case.hpp"
#include "reports/document/json_lines.hpp"

namespace plumb::reports {
namespace {

class KindsReader {
 public:
  KindsReader(Json out, Take run, const std::vector<Kind>& kinds) : out_(std::move(out)), run_(run), kinds_(kinds) {}

  void take(const Field& line) {
    const Field kind = line.member("kind");
    const std::string word = kind.text();
    if (out_["interrupted"] == true) kind.fail("comes after the line of kind interrupted");
    if ((word == "run") != out_["host"].is_null())
      kind.fail(word == "run" ? "'run' is there twice" : "'" + word + "' comes before the line of kind run");
    if (word == "run")
      run_(out_, line);
    else if (word == "interrupted")
      out_["interrupted"] = true;
    else
      take_kind(kind, line);
  }

  [[nodiscard]] bool is_empty() const { return known_.empty(); }
  [[nodiscard]] const Json& document() const { return out_; }

 private:
  void take_kind(const Field& kind, const Field& line) {
    std::string names = "run";
    for (const Kind& known : kinds_) {
      if (kind.text() == known.name) {
        known.take(out_, line);
        return refuse_twice(known, line);
      }
      names += ", " + std::string(known.name);
    }
    kind.fail("'" + kind.text() + "' is none of " + names + ", interrupted");
  }

  /// 2 and 2.0 are one number.
  static Json comparable(const Json& value) { return value.is_number() ? Json(value.get<double>()) : value; }

  void refuse_twice(const Kind& kind, const Field& line) {
    std::string values = kind.name;
    for (const char* field : kind.key) values += " " + comparable(line.member(field).value()).dump();
    if (known_.insert(values).second) return;
    std::string others;
    for (std::size_t i = 0; i + 1 < kind.key.size(); ++i)
      others += (i == 0 ? ", of " : " and ") + std::string(kind.key[i]);
    line.member(kind.key.back()).fail("is there twice" + others);
  }

  Json out_;
  Take run_;
  const std::vector<Kind>& kinds_;
  std::set<std::string> known_;
};

}  // namespace

Json read_kinds(const std::filesystem::path& file, Json out, Take run, const std::vector<Kind>& kinds, const char* of) {
  KindsReader reader(std::move(out), run, kinds);
  for_each_line(file, [&](const Field& line) { reader.take(line); });
  if (reader.is_empty()) throw InputFailure(file.string(), 0, "", std::string("holds no result of ") + of);
  return reader.document();
}

}  // namespace plumb::reports
