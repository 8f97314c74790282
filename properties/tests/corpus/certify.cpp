// plumb certify: the contract's fields, and decimals that are rounded outwards.
#include <algorithm>

#include "properties/tests/corpus/certifying.hpp"

namespace plumb {
namespace {

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

}  // namespace
}  // namespace plumb
