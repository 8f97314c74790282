// plumb certify: the contract's fields, decimals that are rounded outwards, stored proofs and what their verifier refuses.
#include <algorithm>
#include <functional>

#include "corpus/decimal.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

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

std::string ellipsoids() {
  return sample_with("[1, 1, 1]", "[1, 0.8, 1.3]");
}

std::string apart() {
  return sample_with("[1.5, 0, 0]", "[3.5, 0.25, 0]");
}

std::string at_the_origin(std::string text) {
  return text.replace(text.rfind("[1.5, 0, 0]"), 11, "[0, 0, 0]");
}

/// A sphere in a spheroid: every direction across the axis is as low.
std::string coaxial() {
  return at_the_origin(sample_with("[1, 1, 1]", "[1, 1, 2]"));
}

std::string concentric() {
  return at_the_origin(sample_case());
}

/// Whether the decimals of lower and upper hold the value between them.
bool encloses(const Json& overlap, const char* value) {
  const Real50 x(value);
  return read_decimal(overlap["lower"].get<std::string>(), Rounding::up) <= x &&
         read_decimal(overlap["upper"].get<std::string>(), Rounding::down) >= x;
}

TEST_F(Certifying, GivesTheContractsFields) {
  (void)file("a.json", ellipsoids());
  const Json found = certificate("a.json");
  std::vector<std::string> keys;
  for (const auto& [key, value] : found.items()) keys.push_back(key);
  const std::vector<std::string> wanted{"name",   "verdict",       "overlap", "normal",           "normal_radius",
                                        "points", "points_radius", "unique",  "global",           "tied",
                                        "digits", "condition",     "nearby",  "condition_claims", "timing"};
  EXPECT_EQ(keys, wanted);
  EXPECT_EQ(found["name"], "sample");
  EXPECT_EQ(found["verdict"], "overlapping");
  EXPECT_EQ(found["unique"], "proved");
  EXPECT_EQ(found["global"], "proved");
  EXPECT_EQ(found["digits"], 50);
  EXPECT_TRUE(found["tied"].is_array() && found["tied"].empty());
  EXPECT_GE(found["condition"]["overlap"].get<double>(), 1);
  for (const char* of : {"overlap", "normal", "points"}) EXPECT_EQ(found["condition_claims"][of], "certified") << of;
  EXPECT_GE(found["timing"]["ms"].get<double>(), 0);
}

TEST_F(Certifying, SpheresAreExact) {
  (void)file("a.json", sample_with("sample", "spheres"));
  const Json found = certificate("a.json");
  EXPECT_EQ(found["name"], "spheres");
  EXPECT_TRUE(encloses(found["overlap"], "0.5"));
  const Real50 width =
      Real50(found["overlap"]["upper"].get<std::string>()) - Real50(found["overlap"]["lower"].get<std::string>());
  EXPECT_LT(width, Real50("1e-48"));
  const Real50 radius(found["normal_radius"].get<std::string>());
  const std::array<const char*, 3> normal{"1", "0", "0"}, point2{"0.5", "0", "0"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(abs(Real50(found["normal"][i].get<std::string>()) - Real50(normal[i])), radius);
    EXPECT_LE(abs(Real50(found["points"][1][i].get<std::string>()) - Real50(point2[i])),
              Real50(found["points_radius"].get<std::string>()));
  }
  EXPECT_GT(radius, 0);
  EXPECT_LT(radius, Real50("1e-47"));
}

TEST_F(Certifying, FewerDigitsAreRoundedOutwards) {
  (void)file("a.json", ellipsoids());
  const Json all = certificate("a.json");
  for (const int digits : {1, 5, 15, 30}) {
    const Json some = certificate("a.json --digits " + std::to_string(digits));
    EXPECT_EQ(some["digits"], digits);
    for (const char* end : {"lower", "upper"}) {
      const auto text = some["overlap"][end].get<std::string>();
      EXPECT_EQ(text.find('e'), static_cast<std::size_t>(digits == 1 ? 1 : digits + 1)) << text;
      EXPECT_TRUE(encloses(some["overlap"], all["overlap"][end].get<std::string>().c_str())) << text;
    }
    // The true normal is within both radii of what is printed.
    const Real50 radius =
        Real50(some["normal_radius"].get<std::string>()) + Real50(all["normal_radius"].get<std::string>());
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LE(abs(Real50(some["normal"][i].get<std::string>()) - Real50(all["normal"][i].get<std::string>())),
                radius);
  }
}

TEST_F(Certifying, EveryEffortBoundsTheSameOverlap) {
  (void)file("a.json", ellipsoids());
  const auto middle = certificate("a.json")["overlap"]["lower"].get<std::string>();
  for (const char* effort : {"bounds", "proof", "digits"}) {
    const Json found = certificate(std::string("a.json --digits 25 --effort ") + effort);
    EXPECT_TRUE(encloses(found["overlap"], middle.c_str())) << effort;
    EXPECT_EQ(found["verdict"], "overlapping") << effort;
  }
}

TEST_F(Certifying, WhatIsInfiniteIsAWordAndWhatIsOpenIsAbsent) {
  (void)file("a.json", coaxial());
  const Json found = certificate("a.json --effort bounds");
  EXPECT_TRUE(encloses(found["overlap"], "2")) << found["overlap"];
  EXPECT_NE(found["unique"], "proved");
  EXPECT_FALSE(found["reason"].get<std::string>().empty());
  for (const char* key : {"normal", "normal_radius", "points", "points_radius"})
    EXPECT_FALSE(found.contains(key)) << key;
  EXPECT_EQ(found["condition"]["normal"], "infinite");
}

TEST_F(Certifying, RingsAndSolutionSetsTakeThePlaceOfWhatIsInfinite) {
  (void)file("a.json", coaxial());
  const Json found = certificate("a.json");
  EXPECT_EQ(found["global"], "proved");
  EXPECT_NE(found["unique"], "proved");
  ASSERT_EQ(found["rings"].size(), 1U);
  const double right_angle = 1.5707963267948966;
  EXPECT_LT(found["rings"][0]["least_angle"], right_angle);
  EXPECT_GT(found["rings"][0]["greatest_angle"], right_angle);
  EXPECT_EQ(found["condition_claims"]["normal"], "infinite");
  EXPECT_EQ(found["solutions_within"]["epsilons"], 8);
  EXPECT_GE(found["solutions_within"]["normal_radius"], right_angle);
}

TEST_F(Certifying, OneObjectALineUpToABadOne) {
  (void)file("a.jsonl", ellipsoids() + "\n" + apart() + "\n{\"format\": 1}\n");
  const Ran ran = plumb("certify a.jsonl --json --proof kept.proof 2>/dev/null");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(lines_of(ran.out).size(), 2U);
  EXPECT_EQ(lines_of(run("cat " + (path_ / "kept.proof").string()).out).size(), 2U);
  expect_refusal("certify a.jsonl", "a.jsonl:3: format: must be a string, not a number");
}

TEST_F(Certifying, TheTableFitsEightyColumns) {
  (void)file("a.json", ellipsoids());
  const Ran ran = plumb("certify a.json --all");
  EXPECT_EQ(ran.code, 0);
  for (std::size_t begin = 0, end = 0; (end = ran.out.find('\n', begin)) != std::string::npos; begin = end + 1)
    EXPECT_LE(end - begin, 80U) << ran.out.substr(begin, end - begin);
  for (const char* text : {"sample\n", "  verdict      overlapping\n", "  overlap >=   ", "  stationary   minimum\n"})
    EXPECT_NE(ran.out.find(text), std::string::npos) << text;
}

TEST_F(Certifying, AllTellsEveryCommonNormal) {
  (void)file("a.json", ellipsoids());
  const Json found = certificate("a.json --all --digits 30");
  const Json& all = found["stationary"];
  EXPECT_EQ(found["complete"], "proved");
  int balance = 0;
  for (const Json& one : all) {
    for (const char* key : {"kind", "overlap", "normal", "normal_radius", "points", "points_radius"})
      EXPECT_TRUE(one.contains(key)) << key;
    balance += one["kind"] == "saddle" ? -1 : 1;
  }
  EXPECT_EQ(balance, 2);  // minima - saddles + maxima on a sphere
  EXPECT_EQ(all.at(0)["kind"], "minimum");
  EXPECT_TRUE(encloses(all.at(0)["overlap"], found["overlap"]["lower"].get<std::string>().c_str()) ||
              encloses(all.at(0)["overlap"], found["overlap"]["upper"].get<std::string>().c_str()));
}

TEST_F(Certifying, UnusableInputIsOneLineAndTwo) {
  (void)file("a.json", sample_case());
  expect_refusal("certify none.json", "none.json: No such file or directory");
  for (const char* arguments :
       {"certify", "certify a.json --digits 0", "certify a.json --digits 51", "certify a.json --digits x",
        "certify a.json --effort most", "certify a.json --verify p --all", "certify a.json --nonsense"}) {
    const Ran ran = plumb(std::string(arguments) + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
  expect_refusal("certify a.json --proof none/a.proof", "none/a.proof: No such file or directory");
  expect_refusal("certify a.json --verify none.proof", "none.proof: No such file or directory");
  expect_refusal("certify - --verify - <a.json", "--verify: standard input holds the cases");
}

TEST_F(Certifying, StoredProofsHold) {
  (void)file("a.jsonl", ellipsoids() + "\n" + apart() + "\n" + sample_case() + "\n");
  for (const char* effort : {"bounds", "proof", "digits"}) {
    const auto verified = confirmed(effort, 3);
    ASSERT_EQ(verified.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(verified[i]["verdict"], i == 1 ? "separated" : "overlapping");
    EXPECT_TRUE(encloses(verified[2]["overlap"], "0.5"));
  }
}

TEST_F(Certifying, ProofsThatAreNoneAreOneLineAndTwo) {
  (void)file("a.json", ellipsoids());
  const auto expect_unreadable = [&](const std::function<void(Json&)>& change, const std::string& reason) {
    store_changed("a.json", change);
    expect_refusal("certify a.json --verify changed.proof", "changed.proof:1: " + reason);
  };
  expect_unreadable([](Json& p) { p["format"] = "plumb/proof-9"; }, "format: must be \"plumb/proof-1\"");
  expect_unreadable([](Json& p) { p.erase("witnesses"); }, "witnesses: missing");
  expect_unreadable([](Json& p) { p["tree"] = "sxq"; }, "tree: must hold no letters but s, x, o, b and c");
  expect_unreadable([](Json& p) { p["regions"][0]["axis"] = 3; },
                    "regions[0].axis: must be a whole number from 0 to 2");
  expect_unreadable([](Json& p) { p["regions"][0]["sign"] = 0.5; }, "regions[0].sign: must be -1 or 1");
  expect_unreadable([](Json& p) { p["claim"]["overlap"]["lower"] = "nan"; },
                    "claim.overlap.lower: must be a decimal number");
  expect_unreadable([](Json& p) { p["witnesses"][0][0][1] = "x"; },
                    "witnesses[0][0][1]: must be a number, not a string");
  expect_unreadable([](Json& p) { p["bodies"][1]["shape"]["superellipsoid"]["semi_axes"][0] = 0; },
                    "bodies[1].shape.superellipsoid.semi_axes[0]: must be finite and above 0");
  expect_unreadable([](Json& p) { p["colour"] = 1; }, "colour: unknown field");
  (void)file("changed.proof", "\n");
  expect_refusal("certify a.json --verify changed.proof", "changed.proof: holds no proof for case 'sample'");
}

TEST_F(Certifying, AProofOfAnotherCaseIsNone) {
  (void)file("a.json", ellipsoids());
  store_changed("a.json", [](Json& p) { p["x_note"] = "anything"; });
  EXPECT_EQ(plumb("certify a.json --verify changed.proof").code, 0);
  // One unit in the last place, and a zero's sign.
  (void)file("b.json", ellipsoids().replace(ellipsoids().rfind("1.5"), 3, "1.5000000000000002"));
  expect_no_proof("b.json", "it is about another bodies[1]");
  (void)file("b.json", ellipsoids().replace(ellipsoids().find("[0, 0, 0]"), 9, "[0, -0.0, 0]"));
  expect_no_proof("b.json", "it is about another bodies[0]");
}

TEST_F(Certifying, AChangedCoverIsNoProof) {
  (void)file("a.json", ellipsoids());
  const auto expect_broken = [&](const std::function<void(Json&)>& change, const std::string& reason) {
    store_changed("a.json", change);
    expect_no_proof("a.json", reason);
  };
  expect_broken([](Json& p) { p["witnesses"][3][0] = {2, 0, 0}; }, "a witness does not lie in its body");
  expect_broken([](Json& p) { p["witnesses"][3] = {{0, 0, 0}, {0, 0, 0}}; },
                "a leaf is not above the level, or not in its region");
  expect_broken([](Json& p) { p["level"] = 9.0; }, "a leaf is not above the level, or not in its region");
  expect_broken([](Json& p) { p["level"] = -1.0; }, "the level is below zero");
  const auto change_leaf = [](Json& p, char from, char to) {
    auto text = p["tree"].get<std::string>();
    text[text.rfind(from)] = to;
    p["tree"] = text;
  };
  expect_broken([&](Json& p) { change_leaf(p, 's', 'x'); }, "the tree does not cover the six faces of the cube");
  expect_broken([&](Json& p) { change_leaf(p, 'x', 'c'); }, "there is not one witness for each leaf that needs one");
  expect_broken([](Json& p) { p["tree"] = std::string(5000, 's'); },
                "the tree does not cover the six faces of the cube");
  expect_broken([](Json& p) { p["witnesses"].push_back({{0, 0, 0}, {0, 0, 0}}); },
                "there is not one witness for each leaf that needs one");
  expect_broken([](Json& p) { p["regions_of"][0] = 7; }, "a leaf lies in a region that is not there");
  expect_broken([](Json& p) { p["frame"][0] = {1, 1, 1}; }, "the frame is no rotation");
  expect_broken([](Json& p) { p["direction"]["high"] = {0, 0, 0}, p["direction"]["low"] = {0, 0, 0}; },
                "the direction is none");
  expect_broken([](Json& p) { p["regions"][0]["half"] = 1e-9; }, "a leaf is not above the level, or not in its region");
  expect_broken([](Json& p) { p["regions"][0]["solution"]["high"][0] = 0.9; }, "region 0: the solution lies outside");
}

TEST_F(Certifying, ACoverDeeperThanDoublesIsNoProof) {
  (void)file("a.json", ellipsoids());
  store_changed("a.json", [](Json& p) {
    const auto tree = p["tree"].get<std::string>();
    const Json witness = p["witnesses"].back();
    const std::size_t leaf = tree.rfind('x');
    std::string deeper = tree.substr(0, leaf);
    for (int i = 0; i < 60; ++i) deeper += "s";
    deeper += "xxxx";
    for (int i = 0; i < 59; ++i) deeper += "xxx";
    p["tree"] = deeper + tree.substr(leaf + 1);
    for (int i = 0; i < 180; ++i) p["witnesses"].push_back(witness);
  });
  expect_no_proof("a.json", "the tree is deeper than 48 levels");
}

TEST_F(Certifying, ANarrowerClaimIsNotProved) {
  (void)file("a.json", sample_case());
  const auto narrowed = [&](const char* end, const char* value) {
    store_changed("a.json", [&](Json& p) { p["claim"]["overlap"][end] = value; });
    const Ran ran = plumb("certify a.json --verify changed.proof");
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.out.starts_with("sample: the proof does not hold: it claims more than it proves: overlap." +
                                    std::string(end) + " is "))
        << ran.out;
  };
  narrowed("lower", "0.5000000000000000000000000000001");
  narrowed("upper", "0.4999999999999999999999999999999");
  store_changed("a.json", [](Json& p) { p["claim"]["overlap"] = {{"lower", "-1"}, {"upper", "1e3"}}; });
  EXPECT_EQ(plumb("certify a.json --verify changed.proof").code, 0);
}

TEST_F(Certifying, AChangedProofOfADistanceIsNone) {
  (void)file("a.json", apart());
  const auto expect_broken = [&](const std::function<void(Json&)>& change, const std::string& reason) {
    store_changed("a.json", change);
    expect_no_proof("a.json", reason);
  };
  expect_broken([](Json& p) { p["apart"][0] = {1.5, 0, 0}; }, "a point does not lie in its body");
  expect_broken([](Json& p) { p["direction"] = {{"high", {1, 0, 0}}, {"low", {0, 0, 0}}}; },
                "the direction does not separate the bodies");
  expect_broken([](Json& p) { p["regions"][0]["solution"]["high"][0] = 0.9; }, "region 0: the solution lies outside");
  expect_broken([](Json& p) { p["regions"].push_back(p["regions"][0]); }, "bodies apart need no cover");
  expect_too_little([](Json& p) { p["apart"] = {{0, 0, 0}, {0, 0, 0}}, p["regions"] = Json::array(); });
}

TEST_F(Certifying, ProofsOfRingsHold) {
  (void)file("a.jsonl", coaxial() + "\n" + concentric() + "\n");
  for (const char* effort : {"bounds", "proof", "digits"}) {
    for (const Json& one : confirmed(effort, 2)) {
      EXPECT_EQ(one["verdict"], "overlapping");
      EXPECT_TRUE(encloses(one["overlap"], "2"));
    }
  }
}

TEST_F(Certifying, AChangedMeridianIsNoProof) {
  (void)file("a.json", coaxial());
  const auto expect_broken = [&](const std::function<void(Json&)>& change, const std::string& reason) {
    store_changed("a.json", change);
    expect_no_proof("a.json", reason);
  };
  const std::string misshapen = "the arcs are no half circle, or a witness does not lie in its body";
  expect_broken([](Json& p) { p["meridian"]["witnesses"][3][0] = {2, 0, 0}; }, misshapen);
  expect_broken([](Json& p) { p["meridian"]["witnesses"].erase(3); }, misshapen);
  expect_broken([](Json& p) { p["meridian"]["places"].erase(0), p["meridian"]["witnesses"].erase(0); }, misshapen);
  expect_broken([](Json& p) { std::swap(p["meridian"]["places"][1], p["meridian"]["places"][2]); }, misshapen);
  expect_broken(
      [](Json& p) { p["meridian"]["places"] = {0, 4}, p["meridian"]["witnesses"] = {{{0, 0, 0}, {0, 0, 0}}}; },
      misshapen);
  const std::string unbounded = "the bodies are not of revolution about one line, or an arc is not bounded";
  expect_broken([](Json& p) { p["meridian"]["witnesses"][0] = {{0, 0, -0.2}, {0, 0, 0.2}}; }, unbounded);
  // A place that is not the lowest, an arc with a corner, true points and a true turn's bound: they bound too little.
  expect_too_little([](Json& p) { p["meridian"]["valleys"][0]["low"] = 1e-12; });
  expect_too_little([](Json& p) { p["meridian"]["valleys"][0]["last"] = 3.5; });
  expect_too_little([](Json& p) { p["meridian"]["witnesses"][3] = {{0, 0, 0}, {0, 0, 0}}; });
  expect_too_little([](Json& p) { p["frame"] = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}; });
}

TEST_F(Certifying, OnlySpheresHaveTheProofOfSpheres) {
  (void)file("a.json", concentric());
  store_changed("a.json", [](Json& p) { p["bodies"] = Json::parse(coaxial())["bodies"]; });
  (void)file("a.json", coaxial());
  expect_no_proof("a.json", "the bodies are no spheres");
}

TEST_F(Certifying, OtherProblemsHaveTheirOwnAnswers) {
  (void)file("a.json", sample_case());
  for (const char* problem : {"deepest_points", "midway"}) {
    const Json found = certificate(std::string("a.json --problem ") + problem);
    EXPECT_EQ(found["problem"], problem);
    EXPECT_EQ(found["unique"], "proved");
    EXPECT_TRUE(encloses(found["overlap"], "0.5"));
    EXPECT_TRUE(found.contains("points"));
  }
  const Json touch = certificate("a.json --problem first_touch");
  EXPECT_EQ(touch["global"], "proved");
  EXPECT_TRUE(encloses(touch["distance"], "2"));
  EXPECT_TRUE(encloses(touch["overlap"], "0.5"));
  EXPECT_TRUE(touch.contains("normal"));
  (void)file("b.json", coaxial());
  for (const char* problem : {"deepest_points", "first_touch"}) {
    const Json found = certificate(std::string("b.json --problem ") + problem);
    EXPECT_TRUE(found["reason"].get<std::string>().starts_with("coincident centres"));
    EXPECT_FALSE(found.contains("overlap"));
  }
  EXPECT_EQ(plumb("certify a.json --problem nearest 2>/dev/null").code, 2);
  EXPECT_EQ(plumb("certify a.json --problem midway --all 2>/dev/null").code, 2);
}

TEST_F(Certifying, EachCaseNeedsItsOwnProof) {
  (void)file("a.json", ellipsoids());
  (void)file("two.jsonl", ellipsoids() + "\n" + ellipsoids() + "\n");
  EXPECT_EQ(plumb("certify two.jsonl --proof two.proof").code, 0);
  EXPECT_EQ(plumb("certify two.jsonl --verify two.proof").code, 0);
  expect_refusal("certify a.json --verify two.proof", "two.proof:2: is for no case");
  EXPECT_EQ(plumb("certify a.json --proof one.proof").code, 0);
  expect_refusal("certify two.jsonl --verify one.proof", "one.proof: holds no proof for case 'sample'");
}

}  // namespace
}  // namespace plumb
