#include "fuzz/shrink/fixed_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/container_hash/hash.hpp>
#include <numeric>

#include "fuzz/results/counts.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t kFew = 8;  // below it a habit may be chance

std::size_t place_of(Verdict certified, Verdict said) {
  return 3 * static_cast<std::size_t>(certified) + static_cast<std::size_t>(said);
}

std::uint64_t digest_of(const Contact<double>& answer) {
  std::size_t hash = 0;
  boost::hash_combine(hash, static_cast<int>(answer.status));
  boost::hash_combine(hash, static_cast<int>(answer.verdict));
  boost::hash_combine(hash, std::bit_cast<std::uint64_t>(answer.overlap));
  for (const Vec3<double>* v : {&answer.normal, &answer.point1, &answer.point2})
    for (const double x : *v) boost::hash_combine(hash, std::bit_cast<std::uint64_t>(x));
  return hash >> 11;
}

}  // namespace

void Habits::add(Verdict certified, const Contact<double>& answer) {
  if (answer.status == Status::invalid_input) {
    ++refusals;
    return;
  }
  if (answer.method.empty()) return;
  ++verdicts[place_of(certified, answer.verdict)];
  least_digest = std::min(least_digest, digest_of(answer));
  greatest_digest = std::max(greatest_digest, digest_of(answer));
}

void Habits::merge(const Habits& other) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i] += other.verdicts[i];
  refusals += other.refusals;
  least_digest = std::min(least_digest, other.least_digest);
  greatest_digest = std::max(greatest_digest, other.greatest_digest);
}

std::vector<std::string> Habits::in_words() const {
  const auto given = std::accumulate(verdicts.begin(), verdicts.end(), std::uint64_t{0});
  std::vector<std::string> words;
  if (refusals >= kFew && given == 0) words.push_back(fmt::format("refuses all {} pairs", refusals));
  if (given >= kFew && least_digest == greatest_digest)
    words.push_back(fmt::format("gives one and the same answer to all {} pairs", given));
  for (const Verdict truth : {Verdict::overlapping, Verdict::separated}) {
    std::uint64_t pairs = 0;
    for (const Verdict said : {Verdict::undecided, Verdict::overlapping, Verdict::separated})
      pairs += verdicts[place_of(truth, said)];
    if (pairs >= kFew && verdicts[place_of(truth, truth)] == 0)
      words.push_back(fmt::format("never says {0}: 0 of {1} {0} pairs", name(truth), pairs));
  }
  return words;
}

Json Habits::to_json() const {
  return {{"verdicts", verdicts},
          {"refusals", refusals},
          {"least_digest", least_digest},
          {"greatest_digest", greatest_digest}};
}

Habits Habits::read(const Field& field) {
  Habits habits;
  read_counts(habits.verdicts, field, "verdicts");
  habits.refusals = count_at(field, "refusals");
  habits.least_digest = count_at(field, "least_digest");
  habits.greatest_digest = count_at(field, "greatest_digest");
  return habits;
}

}  // namespace plumb
