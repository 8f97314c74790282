// What the tests of plumb certify share: its answers, proofs stored and changed, and cases to certify.
#pragma once

#include <functional>

#include "corpus/json/decimal.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {

class Certifying : public Commands {
 protected:
  [[nodiscard]] Json certificate(const std::string& arguments) const {
    const Ran ran = plumb("certify " + arguments + " --json");
    EXPECT_EQ(ran.code, 0) << arguments;
    const auto lines = lines_of(ran.out);
    return lines.size() == 1 ? lines[0] : Json();
  }

  /// The proof of a case, after a change.
  void store_changed(const std::string& name, const std::function<void(Json&)>& change) const {
    EXPECT_EQ(plumb("certify " + name + " --proof whole.proof").code, 0);
    Json proof = Json::parse(run("cat " + (path_ / "whole.proof").string()).out);
    change(proof);
    (void)file("changed.proof", write_json(proof) + "\n");
  }

  /// Proofs of a.jsonl's cases stored and confirmed; what their verification printed.
  [[nodiscard]] std::vector<Json> confirmed(const std::string& effort, std::size_t cases) const {
    const auto found = lines_of(plumb("certify a.jsonl --json --proof p --effort " + effort).out);
    const Ran ran = plumb("certify a.jsonl --verify p --json");
    EXPECT_EQ(ran.code, 0) << ran.out;
    auto verified = lines_of(ran.out);
    EXPECT_EQ(found.size(), cases);
    EXPECT_EQ(verified.size(), cases);
    for (const Json& one : found) EXPECT_EQ(one["proof"], "stored");
    for (const Json& one : verified) EXPECT_EQ(one["proof"], "holds");
    return verified;
  }

  /// True in all its parts, but it proves less than it claims.
  void expect_too_little(const std::function<void(Json&)>& change) const {
    store_changed("a.json", change);
    EXPECT_EQ(plumb("certify a.json --verify changed.proof").code, 1);
  }

  void expect_no_proof(const std::string& name, const std::string& reason) const {
    const Ran ran = plumb("certify " + name + " --verify changed.proof");
    EXPECT_EQ(ran.code, 1) << ran.out;
    EXPECT_EQ(ran.out, "sample: the proof does not hold: " + reason + "\n");
  }
};

inline std::string ellipsoids() {
  return sample_with("[1, 1, 1]", "[1, 0.8, 1.3]");
}

inline std::string apart() {
  return sample_with("[1.5, 0, 0]", "[3.5, 0.25, 0]");
}

inline std::string at_the_origin(std::string text) {
  return text.replace(text.rfind("[1.5, 0, 0]"), 11, "[0, 0, 0]");
}

/// A sphere in a spheroid: every direction across the axis is as low.
inline std::string coaxial() {
  return at_the_origin(sample_with("[1, 1, 1]", "[1, 1, 2]"));
}

inline std::string concentric() {
  return at_the_origin(sample_case());
}

/// Whether the decimals of lower and upper hold the value between them.
inline bool encloses(const Json& overlap, const char* value) {
  const Real50 x(value);
  return read_decimal(overlap["lower"].get<std::string>(), Rounding::up) <= x &&
         read_decimal(overlap["upper"].get<std::string>(), Rounding::down) >= x;
}

}  // namespace plumb
