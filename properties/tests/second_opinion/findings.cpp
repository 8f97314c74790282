// Findings about every method that is here, confirmed by the program that shares no code with plumb; and lies, refuted by it.
#include <gtest/gtest.h>

#include <map>

#include "properties/generators/families.hpp"
#include "properties/tests/draws.hpp"
#include "properties/tests/kept_references.hpp"
#include "properties/tests/second_opinion/asking.hpp"
#include "properties/tests/second_opinion/evidence.hpp"

namespace plumb {
namespace {

/// What one answer does not show.
bool takes_the_solver(FindingKind kind) {
  return kind == FindingKind::crash || kind == FindingKind::asymmetric || kind == FindingKind::nondeterministic ||
         kind == FindingKind::slow;
}

bool says_nothing_of_numbers(FindingKind kind) {
  return kind == FindingKind::nonconverged || kind == FindingKind::not_finite;
}

/// So many flagged and so many passed answers of each solver are enough.
class Drawn {
 public:
  explicit Drawn(std::size_t enough) : enough_(enough) {}

  void take(Evidenced evidence) {
    if (takes_the_solver(evidence.finding) || says_nothing_of_numbers(evidence.finding)) return;
    std::size_t& had = count_[{evidence.solver, evidence.finding != FindingKind::none}];
    if (had++ < enough_) all_.push_back(std::move(evidence));
  }
  [[nodiscard]] const std::vector<Evidenced>& all() const { return all_; }
  [[nodiscard]] std::size_t count(const std::string& solver, bool flagged) const {
    const auto found = count_.find({solver, flagged});
    return found == count_.end() ? 0 : std::min(found->second, enough_);
  }
  [[nodiscard]] std::vector<Json> lines() const {
    std::vector<Json> out;
    for (const Evidenced& e : all_) out.push_back(e.line);
    return out;
  }

 private:
  std::size_t enough_;
  std::map<std::pair<std::string, bool>, std::size_t> count_;
  std::vector<Evidenced> all_;
};

/// Every solver of this build but first_touch, whose problem the program does not know.
std::vector<Solver> judged_solvers() {
  std::vector<Solver> out = all_solvers();
  std::erase_if(out, [](const Solver& s) { return s.abilities.problem == Problem::first_touch; });
  return out;
}

/// The same number of each family, in turns.
const Drawn& drawn() {
  static const Drawn all = [] {
    Drawn out(draws(50, 5));
    const std::vector<Solver> solvers = judged_solvers();
    const ReferenceSource source = kept_references();
    const std::uint64_t seed = 30, pairs = draws(120, 8);
    for (std::uint64_t i = 0; i < pairs; ++i)
      for (const Family& family : families())
        for (Evidenced& e : evidence(generate(family.name, seed, i), solvers, source)) out.take(std::move(e));
    return out;
  }();
  return all;
}

std::size_t count(const std::vector<Json>& said, const std::string& verdict) {
  return static_cast<std::size_t>(
      std::count_if(said.begin(), said.end(), [&](const Json& s) { return s.at("verdict") == verdict; }));
}

/// The same answers with a word about them that is not true.
std::vector<Json> lies(FindingKind told, const std::string& instead) {
  std::vector<Json> out;
  for (const Evidenced& e : drawn().all()) {
    if (e.finding != told || e.line.at("problem") != "common_normal") continue;
    out.push_back(e.line);
    out.back()["finding"] = instead;
  }
  return out;
}

TEST(second_opinion, confirms_what_plumb_finds_of_every_method) {
  const Drawn& all = drawn();
  const SecondOpinions opinions = ask_second_opinion(all.lines());
  ASSERT_EQ(opinions.said.size(), all.all().size());
  for (std::size_t i = 0; i < opinions.said.size(); ++i)
    EXPECT_NE(opinions.said[i].at("verdict"), "refuted") << opinions.said[i].dump() << "\n" << all.all()[i].line.dump();
  EXPECT_EQ(opinions.code, 0);
  // Faces as good as flat, where the deepest points are not determined.
  EXPECT_LE(count(opinions.said, "unsure"), opinions.said.size() / 10);
}

TEST(second_opinion, is_asked_about_flagged_and_passed_answers_alike) {
  for (const char* solver : {"original_cn", "corrected_cn", "geometric_potential"})
    EXPECT_GE(drawn().count(solver, true), draws(20, 2)) << solver;
  for (const char* solver : {"auto", "corrected_cn", "geometric_potential", "geometric_potential_midway"})
    EXPECT_GE(drawn().count(solver, false), draws(20, 2)) << solver;
  EXPECT_EQ(drawn().count("auto", true), 0U);
}

TEST(second_opinion, refutes_that_a_right_answer_is_wrong) {
  for (const char* accusation : {"misaligned", "wrong_branch", "overlap_error", "false_contact", "missed_contact"}) {
    const std::vector<Json> told = lies(FindingKind::none, accusation);
    ASSERT_GE(told.size(), 10U);
    const SecondOpinions opinions = ask_second_opinion(told);
    EXPECT_EQ(opinions.code, 1) << accusation;
    EXPECT_EQ(count(opinions.said, "confirmed"), 0U) << accusation;
    EXPECT_GE(count(opinions.said, "refuted"), told.size() * 8 / 10) << accusation;
  }
}

TEST(second_opinion, refutes_that_a_wrong_answer_is_right) {
  for (const FindingKind kind : {FindingKind::misaligned, FindingKind::wrong_branch, FindingKind::missed_contact}) {
    const std::vector<Json> told = lies(kind, "none");
    if (told.empty()) continue;
    const SecondOpinions opinions = ask_second_opinion(told);
    EXPECT_EQ(opinions.code, 1) << name(kind);
    EXPECT_GE(count(opinions.said, "refuted"), told.size() * 8 / 10) << name(kind);
  }
  EXPECT_FALSE(lies(FindingKind::misaligned, "none").empty());
}

}  // namespace
}  // namespace plumb
