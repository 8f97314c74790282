// What a campaign found, in a form that adds up (over threads, shards and runs), and its files.
//
// DIR/summary.json   the contract's summary
// DIR/campaign.bins  the counts behind it, for `plumb merge`
// DIR/failures/      the simplest and the worst case of each bucket
// FILE.part          the last two as one file (chunks.hpp)
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "fuzz/campaign/request.hpp"
#include "fuzz/results/failure_store.hpp"
#include "fuzz/results/ladders.hpp"
#include "fuzz/results/tally.hpp"

namespace plumb {

/// What is known of a foreign solver without asking it again.
struct ForeignSolver {
  std::string option;  ///< by which it is loaded (Solver::option)
  Abilities abilities;
};

using Tallies = std::map<std::string, Tally>;  ///< by the method that answered

struct FamilyResults {
  std::uint64_t cases = 0;
  std::uint64_t digest = 0;               ///< of the pairs, in any order: whether two runs had the same cases
  std::uint64_t reference_unsolved = 0;   ///< no certified common normal: CN methods go unjudged
  std::uint64_t not_proved_lowest = 0;    ///< the bounds of the overlap are wider than 1e-12 of the size
  std::uint64_t reference_beaten = 0;     ///< an answer's normal proves a lower overlap than the reference's
  std::array<std::uint64_t, 3> needed{};  ///< cases by the dearest Effort that their answers took to judge
  Tallies methods;
  std::map<std::string, Tallies> generators;  ///< of the family `hard`
  Ladders ladders;                            ///< the same, by step

  void merge(const FamilyResults& other);
  /// Other methods on the same cases, which are counted once.
  void join(const FamilyResults& other);

 private:
  void add_methods(const FamilyResults& other);
};

struct Results {
  Asked asked;
  bool interrupted = false;     ///< this run, or one of those that were merged
  bool shards_missing = false;  ///< from a merge; one shard alone is all that was asked of it
  std::map<std::string, FamilyResults> families;
  std::map<std::string, std::uint64_t> buckets;         ///< failures in each
  std::map<std::string, std::uint64_t> harness_errors;  ///< message -> cases
  std::map<std::string, ForeignSolver> foreign;         ///< by their names
  std::map<std::string, Leak> leaks;                    ///< of foreign solvers
  std::set<std::string> given_up;                       ///< foreign solvers that did not come back too often
  KeptFailures kept;
  /// What CampaignOptions::keeps_answers asks for: by family and index, a line of JSON; in no file of a campaign's own.
  std::map<std::pair<std::string, std::uint64_t>, std::string> answers;
  std::set<std::string> hosts;  ///< machine and build of each part, as JSON (corpus/command/build_info.hpp)
  double seconds = 0;           ///< wall clock, added up over merged runs
  unsigned threads = 0;

  void merge(Results&& other);
  /// Of other methods on the same cases.
  void join(Results&& other);
  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] Tallies methods() const;  ///< over all families
  /// The one host, or a list where parts of several were merged.
  [[nodiscard]] Json hosts_json() const;
  [[nodiscard]] bool incomplete() const { return interrupted || shards_missing || !given_up.empty(); }

 private:
  void add_the_rest(Results&& other);
};

/// A method that is no published baseline, the reference or the harness has a finding, or a foreign solver leaks.
[[nodiscard]] bool has_finding(const Results& results);

/// 130 when interrupted or without some of the shards; 1 when there is a finding; else 0.
[[nodiscard]] int exit_code(const Results& results);

/// real, spheroid, ellipsoid, superquadric, hard; methods in the order of `plumb methods`, foreign ones last.
[[nodiscard]] std::vector<std::string> family_order(const Results& results);
[[nodiscard]] std::vector<std::string> method_order(const Tallies& tallies);
/// Ladders in the order of `plumb families`.
[[nodiscard]] std::vector<std::string> ladder_order(const Ladders& ladders);

/// Cases by the dearest effort that judging them took.
[[nodiscard]] Json needed_json(const FamilyResults& family);
[[nodiscard]] Json leak_json(const Leak& leak);
[[nodiscard]] Json summary_json(const Results& results);

/// The text of campaign.bins and back; `file` names it in errors. Without the failures that are kept. Throws InputFailure.
[[nodiscard]] std::string format_bins(const Results& results);
[[nodiscard]] Results parse_bins(const std::string& text, const std::string& file);

/// A campaign as one file: the text of campaign.bins, then a line for each file of failures/.
[[nodiscard]] std::string format_part(const Results& results);
/// Throws InputFailure, which names the file and the line.
[[nodiscard]] Results read_part(const std::filesystem::path& file);

/// Makes DIR and DIR/failures and tries to write there; throws InputFailure. Called before the work starts. What an earlier run
/// left there is removed, so that a folder never shows one run's counts beside another's failures, or those of a run that died.
void prepare_folder(const std::filesystem::path& folder);
void write_results(const Results& results, const std::filesystem::path& folder);
/// A folder, or a part as one file. Throws InputFailure, which names the file.
[[nodiscard]] Results read_results(const std::filesystem::path& folder);

}  // namespace plumb
