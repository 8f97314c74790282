#include "corpus/case/contract_words.hpp"

#include <algorithm>
#include <array>

namespace plumb {
namespace {

constexpr std::array statuses{Status::converged, Status::iteration_limit, Status::stalled,
                              Status::singular,  Status::not_finite,      Status::invalid_input};
constexpr std::array verdicts{Verdict::undecided, Verdict::overlapping, Verdict::separated};
constexpr std::array<std::string_view, 14> findings{
    "crash",       "not_finite",    "nonconverged", "false_contact", "missed_contact",   "wrong_branch", "misaligned",
    "off_surface", "overlap_error", "point_error",  "asymmetric",    "nondeterministic", "slow",         "none"};

template <class T, std::size_t N>
std::array<std::string_view, N> names_of(const std::array<T, N>& values) {
  std::array<std::string_view, N> out;
  std::transform(values.begin(), values.end(), out.begin(), [](T value) { return name(value); });
  return out;
}

std::size_t index_of(const Field& field, std::span<const std::string_view> words) {
  const std::string text = field.text();
  const auto found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  field.fail("must be one of " + list);
}

}  // namespace

std::span<const std::string_view> status_words() {
  static const auto words = names_of(statuses);
  return words;
}

std::span<const std::string_view> verdict_words() {
  static const auto words = names_of(verdicts);
  return words;
}

std::span<const std::string_view> finding_words() {
  return findings;
}

void require_word(const Field& field, std::span<const std::string_view> words) {
  (void)index_of(field, words);
}

Status read_status(const Field& field) {
  return statuses[index_of(field, status_words())];
}

Verdict read_verdict(const Field& field) {
  return verdicts[index_of(field, verdict_words())];
}

}  // namespace plumb
