// What a campaign was asked for, and which parts of it are done: only parts of one campaign add up.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "corpus/case/case.hpp"

namespace plumb {

/// Case index i of each source belongs to the shard i % count + 1.
struct Shard {
  std::uint64_t number = 1, count = 1;
};

struct Asked {
  std::uint64_t seed = 0;
  std::map<std::string, std::uint64_t> cases;  ///< of each family, in all shards together
  std::set<std::string> methods;
  std::string accuracy = "rounding";  ///< as parse_accuracy() reads it (properties/laws/accuracy.hpp)
  std::uint64_t shards = 1;           ///< into how many parts the cases were divided
  std::set<std::uint64_t> done;       ///< which of them are here, counted from 1

  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  [[nodiscard]] static Asked read(const Field& field);
};

}  // namespace plumb
