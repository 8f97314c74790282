#include "fuzz/campaign/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <thread>

#include "corpus/json/nearest_word.hpp"
#include "corpus/json/number_text.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/families_shapes.hpp"

namespace plumb {

std::vector<std::string> find_families(const std::string& names) {
  std::vector<std::string> known = family_names();
  if (names == "all") return known;  // those of superellipsoids: no other method answers the others
  for (const ShapeFamily& family : shape_families()) known.emplace_back(family.name);
  return find_families(names, known, "plumb families");
}

std::vector<std::string> find_families(const std::string& names, const std::vector<std::string>& known,
                                       const std::string& listed_by) {
  if (names == "all") return known;
  std::vector<std::string> found;
  std::stringstream list(names);
  for (std::string one; std::getline(list, one, ',');) {
    if (std::find(known.begin(), known.end(), one) == known.end())
      throw InputFailure("--family", 0, one, no_such("family", one, known, listed_by));
    if (std::find(found.begin(), found.end(), one) == found.end()) found.push_back(one);
  }
  if (found.empty()) throw InputFailure("--family", 0, "", "names no family; " + listed_by + " lists them");
  return found;
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = number_from<std::uint64_t>(text.substr(0, slash));
  const auto count = number_from<std::uint64_t>(text.substr(std::min(slash + 1, text.size())));
  if (!number || !count || *number < 1 || *number > *count || *count > kMostParts)
    throw InputFailure("plumb campaign", 0, "--shard",
                       fmt::format("'{}' is not i/n with 1 <= i <= n (at most 1e9)", text));
  return {*number, *count};
}

std::string refuse_minutes(const std::string& text) {
  constexpr double most = 1e6;  // two years; the counts that it stands for are far from overflow
  const auto minutes = number_from<double>(text);
  return minutes && *minutes > 0 && *minutes <= most ? ""
                                                     : fmt::format("'{}' is not a number above 0, at most 1e6", text);
}

unsigned default_threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace plumb
