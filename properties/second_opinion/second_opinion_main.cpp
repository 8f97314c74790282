// second-opinion FILE.jsonl: what an independent computation in 128 bits says of each answer and of what was found about it.
//
// A line: { "bodies": as in a case file, by quaternion, "answer": the fields of plumb solve, "problem", "accuracy": { "normal": rad, "overlap", "points":
// ratios; 0 or missing: rounding }, "abilities", "finding": the word to be confirmed }. Out comes, a line each,
// { "verdict": "confirmed" | "refuted" | "unsure", "reason": one sentence }. Exit 1 where any is refuted, 2 on unusable input.
//
// It shares no line with plumb and links nothing of it.
#include <fstream>
#include <iostream>
#include <memory>

#include "opinion.hpp"

namespace {

using namespace second_opinion;

constexpr int exit_refuted = 1, exit_unusable = 2;

bool is_same(const GivenPair& a, const GivenPair& b) {
  const auto same = [](const Vec<double>& p, const Vec<double>& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i].axes, b[i].axes) || !same(a[i].position, b[i].position) || a[i].quaternion != b[i].quaternion ||
        a[i].n1 != b[i].n1 || a[i].n2 != b[i].n2)
      return false;
  return true;
}

/// Answers of several solvers to one pair come one after the other: the truth is computed once.
class Kept {
 public:
  Truth& of(const Claim& claim) {
    if (!truth_ || problem_ != claim.problem || !is_same(pair_, claim.pair)) {
      pair_ = claim.pair;
      problem_ = claim.problem;
      truth_ = std::make_unique<Truth>(pair_, problem_);
    }
    return *truth_;
  }

 private:
  GivenPair pair_{};
  Problem problem_{};
  std::unique_ptr<Truth> truth_;
};

const char* word(Verdict verdict) {
  return verdict == Verdict::confirmed ? "confirmed" : verdict == Verdict::refuted ? "refuted" : "unsure";
}

int run(const std::string& path, std::istream& in) {
  Kept kept;
  int code = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      const Claim claim = read_claim(line);
      const Opinion said = opinion(claim, kept.of(claim));
      std::cout << nlohmann::json{{"verdict", word(said.verdict)}, {"reason", said.reason}}.dump() << '\n';
      if (said.verdict == Verdict::refuted) code = exit_refuted;
    } catch (const Unusable& e) {
      std::cerr << path << ':' << number << ": " << e.what() << '\n';
      return exit_unusable;
    }
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "second-opinion: takes one file of lines, or - for standard input\n";
    return exit_unusable;
  }
  const std::string path = argv[1];
  if (path == "-") return run(path, std::cin);
  std::ifstream file(path);
  if (!file) {
    std::cerr << path << ": cannot be read\n";
    return exit_unusable;
  }
  return run(path, file);
}
