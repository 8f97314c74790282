#include "fuzz/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <thread>

#include "properties/families.hpp"

namespace plumb {
namespace {

/// The number that the whole text is.
template <class Number>
std::optional<Number> whole(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || last != end) return std::nullopt;
  return value;
}

}  // namespace

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

std::string refuse_count(const std::string& text) {
  const auto count = whole<std::int64_t>(text);
  return count && *count > 0 ? "" : fmt::format("'{}' is not a whole number above 0", text);
}

std::string refuse_minutes(const std::string& text) {
  constexpr double most = 1e6;  // two years; the counts that it stands for are far from overflow
  const auto minutes = whole<double>(text);
  return minutes && *minutes > 0 && *minutes <= most ? ""
                                                     : fmt::format("'{}' is not a number above 0, at most 1e6", text);
}

unsigned default_threads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace plumb
