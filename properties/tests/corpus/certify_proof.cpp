// plumb certify --proof and --verify: stored proofs, and what their verifier refuses.
#include "properties/tests/corpus/certifying.hpp"

namespace plumb {
namespace {

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
