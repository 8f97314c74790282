#include "fuzz/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <thread>

#include "properties/families.hpp"

namespace plumb {

std::vector<std::string> find_families(const std::string& names) {
  std::vector<std::string> known, found;
  for (const Family& family : families()) known.emplace_back(family.name);
  if (names == "all") return known;
  std::stringstream list(names);
  for (std::string one; std::getline(list, one, ',');) {
    if (std::find(known.begin(), known.end(), one) == known.end())
      throw InputFailure("plumb campaign", 0, "--family",
                         fmt::format("no family '{}'; plumb families lists them", one));
    if (std::find(found.begin(), found.end(), one) == found.end()) found.push_back(one);
  }
  if (found.empty()) throw InputFailure("plumb campaign", 0, "--family", "is empty; plumb families lists them");
  return found;
}

Shard parse_shard(const std::string& text) {
  Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  const bool slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = slash ? std::from_chars(number.ptr + 1, end, shard.count) : number;
  const bool legal =
      slash && count.ec == std::errc() && count.ptr == end && 1 <= shard.number && shard.number <= shard.count;
  if (!legal) throw InputFailure("plumb campaign", 0, "--shard", fmt::format("'{}' is not i/n with 1 <= i <= n", text));
  return shard;
}

unsigned default_threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace plumb
