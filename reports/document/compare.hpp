// Two runs held against each other: what got better, what got worse, what is noise.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"

namespace plumb::reports {

/// Two-sided p of Fisher's exact test of k1 in n1 against k2 in n2 (twice the smaller tail, at most 1);
/// n1 + n2 < 2^32.
[[nodiscard]] double fisher_p(std::uint64_t k1, std::uint64_t n1, std::uint64_t k2, std::uint64_t n2);

/// Two-sided p of the Mann-Whitney test of two histograms of one scale, ties counted, by the normal approximation.
[[nodiscard]] double mann_whitney_p(const Histogram& one, const Histogram& two);

/// Two-sided p of Fisher's exact test of the shares beyond the p99 of both together.
[[nodiscard]] double tail_p(const Histogram& one, const Histogram& two);

/// Holm's step-down adjustment for the number of tests; NaN stands for no test and stays.
void adjust_by_holm(std::vector<double>& p);

/// Whether every family had the same pairs (by their digest), and all that was asked was done.
[[nodiscard]] bool had_same_cases(const Results& one, const Results& two);

/// Shares of findings and percentiles of each method that both runs have, by family. Where the cases are the same no difference is
/// chance: it is of the code, the compiler or the machine; else one whose p, adjusted for the number of rows that differ, is not below
/// 0.05 is noise. Times are not compared: they are of two runs.
[[nodiscard]] Json comparison_json(const Run& before, const Run& after);

}  // namespace plumb::reports
