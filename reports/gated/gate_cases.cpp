#include "reports/gated/gate_cases.hpp"

#include <fmt/format.h>

#include "fuzz/campaign/arguments.hpp"
#include "properties/generators/families.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

fs::path file_of(const GateTable& table, const std::string& ladder) {
  return fs::path(PLUMB_SOURCE_DIR) / table.frozen / (ladder + ".jsonl");
}

std::vector<Case> kept_cases(const GateTable& table, const std::string& ladder) {
  std::vector<Case> out;
  CaseReader reader(file_of(table, ladder).string());
  for (std::optional<Case> c = reader.next(); c; c = reader.next()) out.push_back(*std::move(c));
  return out;
}

}  // namespace

std::vector<std::string> gate_families(const GateTable& table) {
  std::vector<std::string> out;
  if (!table.is_frozen())
    for (const Family& family : families()) out.emplace_back(family.name);
  else
    for (const std::string_view ladder : hard_generators())
      if (fs::exists(file_of(table, std::string(ladder)))) out.emplace_back(ladder);
  return out;
}

std::vector<std::string> chosen_families(const GateTable& table, const std::string& names) {
  if (!table.is_frozen()) return find_families(names);
  return find_families(names, gate_families(table), table.frozen);
}

std::uint64_t count_kept(const GateTable& table, const std::string& ladder) {
  return kept_cases(table, ladder).size();
}

std::vector<Case> gate_cases(const GateTable& table, const std::string& family) {
  const std::uint64_t count = table.cases.at(family);
  if (table.is_frozen()) {
    std::vector<Case> out = kept_cases(table, family);
    if (out.size() != count)
      throw InputFailure(file_of(table, family).string(), 0, "",
                         fmt::format("has {} cases, the table has {}: plumb report-gate --update", out.size(), count));
    return out;
  }
  std::vector<Case> out;
  for (std::uint64_t i = 0; i < count; ++i) out.push_back(generate(family, table.seed, i));
  return out;
}

}  // namespace plumb::reports
