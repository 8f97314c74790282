#include "reports/document/json_lines.hpp"

#include <optional>

#include "corpus/case/case.hpp"
#include "corpus/json/object_reader.hpp"

namespace plumb::reports {

void for_each_line(const std::filesystem::path& file, const std::function<void(const Field&)>& take) {
  ObjectReader objects(file.string(), ObjectReader::Layout::by_content);
  while (const std::optional<std::string> text = objects.next()) {
    try {
      const Json line = read_json(*text);
      take(Field(line));
    } catch (const FieldError& e) {
      throw InputFailure(file.string(), objects.line(), e.field, e.what());
    }
  }
}

}  // namespace plumb::reports
