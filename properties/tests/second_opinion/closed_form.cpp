// Pairs whose contact is known by hand: what the second opinion expects of them, and the fifteen lines of Python beside it.
#include <gtest/gtest.h>

#include <cmath>

#include "properties/tests/second_opinion/asking.hpp"

namespace plumb {
namespace {

Json body(const std::vector<double>& axes, const std::vector<double>& position, double exponent = 2) {
  return {{"shape", {{"superellipsoid", {{"semi_axes", axes}, {"exponents", {exponent, exponent}}}}}},
          {"position", position},
          {"orientation", {{"quaternion_wxyz", {1, 0, 0, 0}}}}};
}

Json answer(double overlap, const std::vector<double>& normal, const std::vector<double>& p1,
            const std::vector<double>& p2) {
  return {{"status", "converged"}, {"overlap", overlap}, {"normal", normal}, {"points", {p1, p2}}};
}

Json claim(const Json& bodies, const Json& answer, const std::string& finding, const Json& accuracy = Json::object()) {
  return {{"bodies", bodies}, {"answer", answer}, {"finding", finding}, {"accuracy", accuracy}};
}

std::string verdict(const Json& claim) {
  const SecondOpinions opinions = ask_second_opinion({claim});
  return opinions.said.size() == 1 && opinions.code != 2 ? opinions.said[0].at("verdict").get<std::string>() : "none";
}

/// Radii 1 and 0.5, centres 1.25 apart along x: a depth of 0.25.
const Json spheres{body({1, 1, 1}, {0, 0, 0}), body({0.5, 0.5, 0.5}, {1.25, 0, 0})};
const Json of_spheres = answer(0.25, {1, 0, 0}, {1, 0, 0}, {0.75, 0, 0});
/// Ellipsoids one above the other along their shortest axes, 0.5 apart.
const Json ellipsoids{body({2, 1.5, 1}, {0, 0, 0}), body({3, 2, 0.5}, {0, 0, 2})};
const Json of_ellipsoids = answer(-0.5, {0, 0, 1}, {0, 0, 1}, {0, 0, 1.5});
/// Of exponent 8, like boxes, a corner of one above the middle of a face of the other: 0.125 deep.
const Json boxes{body({2, 2, 1}, {0, 0, 0}, 8), body({0.5, 0.5, 0.5}, {0.25, 0, 1.375}, 8)};

TEST(closed_form, right_answers_are_right) {
  EXPECT_EQ(verdict(claim(spheres, of_spheres, "none")), "confirmed");
  EXPECT_EQ(verdict(claim(ellipsoids, of_ellipsoids, "none")), "confirmed");
  const Json& on_faces = answer(0.125, {0, 0, 1}, {0.25, 0, 1}, {0.25, 0, 0.875});
  EXPECT_EQ(verdict(claim(boxes, on_faces, "none", {{"overlap", 1e-6}, {"normal", 1e-3}, {"points", 0.3}})),
            "confirmed");
}

TEST(closed_form, right_answers_are_not_wrong_in_any_way) {
  for (const char* accusation : {"misaligned", "wrong_branch", "overlap_error", "point_error", "off_surface",
                                 "missed_contact", "false_contact", "nonconverged", "not_finite"}) {
    EXPECT_EQ(verdict(claim(spheres, of_spheres, accusation)), "refuted") << accusation;
    EXPECT_EQ(verdict(claim(ellipsoids, of_ellipsoids, accusation)), "refuted") << accusation;
  }
}

TEST(closed_form, each_way_to_be_wrong_is_confirmed_and_not_passed) {
  const double tilt = 1e-9;
  const std::map<std::string, Json> wrong{
      {"wrong_branch", answer(2.75, {-1, 0, 0}, {-1, 0, 0}, {1.75, 0, 0})},
      {"misaligned", answer(0.25, {std::cos(tilt), std::sin(tilt), 0}, {1, 0, 0}, {0.75, 0, 0})},
      {"overlap_error", answer(0.25 + 1e-12, {1, 0, 0}, {1, 0, 0}, {0.75, 0, 0})},
      {"off_surface", answer(0.25, {1, 0, 0}, {1 + 1e-12, 0, 0}, {0.75 + 1e-12, 0, 0})},
      {"point_error", answer(0.25, {1, 0, 0}, {1, 0, 0}, {0.75, 1e-9, 0})},
      {"missed_contact", answer(-0.25, {1, 0, 0}, {1, 0, 0}, {0.75, 0, 0})}};
  for (const auto& [finding, said] : wrong) {
    EXPECT_EQ(verdict(claim(spheres, said, finding)), "confirmed") << finding;
    EXPECT_EQ(verdict(claim(spheres, said, "none")), "refuted") << finding;
  }
  const Json overlapping = answer(0.5, {0, 0, 1}, {0, 0, 1}, {0, 0, 1.5});
  EXPECT_EQ(verdict(claim(ellipsoids, overlapping, "false_contact")), "confirmed");
}

TEST(closed_form, an_error_within_the_accuracy_is_none) {
  const double tilt = 1e-6;
  const Json said = answer(0.25 + 1e-7, {std::cos(tilt), std::sin(tilt), 0}, {1, 0, 0}, {0.75, 0, 0});
  const Json loose{{"normal", 1e-5}, {"overlap", 1e-6}, {"points", 1e-6}}, strict{{"normal", 1e-7}, {"overlap", 1e-8}};
  EXPECT_EQ(verdict(claim(spheres, said, "none", loose)), "confirmed");
  EXPECT_EQ(verdict(claim(spheres, said, "misaligned", loose)), "refuted");
  EXPECT_EQ(verdict(claim(spheres, said, "none", strict)), "refuted");
  EXPECT_EQ(verdict(claim(spheres, said, "misaligned", strict)), "confirmed");
}

/// Equal spheres at one place: every direction is as low.
TEST(closed_form, no_direction_is_called_wrong_where_all_are_as_low) {
  const Json at_one_place{body({1, 1, 1}, {0, 0, 0}), body({1, 1, 1}, {0, 0, 0})};
  const Json said = answer(2, {0, 0.6, 0.8}, {0, 0.6, 0.8}, {0, -0.6, -0.8});
  EXPECT_NE(verdict(claim(at_one_place, said, "misaligned")), "confirmed");
  EXPECT_NE(verdict(claim(at_one_place, said, "none")), "refuted");
}

/// Its deepest points lie along the line of centres of spheres; its point midway where both potentials are equal.
TEST(closed_form, the_geometric_potential_of_spheres) {
  Json said = claim(spheres, of_spheres, "none");
  said["problem"] = "deepest_points";
  EXPECT_EQ(verdict(said), "confirmed");
  said["problem"] = "midway";
  // g1 = x and g2 = (1.25 - x) / 0.5 are equal at 5/6.
  said["answer"]["contact_point"] = {5.0 / 6, 0, 0};
  EXPECT_EQ(verdict(said), "confirmed");
  said["answer"]["contact_point"] = {0.83, 0, 0};
  EXPECT_EQ(verdict(said), "refuted");
}

/// A small ball within a large one: the points deepest in each other's potential are 0.9 apart, and the balls overlap all the same.
TEST(closed_form, a_verdict_is_about_the_bodies_whatever_the_problem) {
  const Json within{body({1, 1, 1}, {0, 0, 0}), body({0.1, 0.1, 0.1}, {0.2, 0, 0})};
  Json said = claim(within, answer(-0.9, {1, 0, 0}, {1, 0, 0}, {0.1, 0, 0}), "missed_contact");
  said["problem"] = "deepest_points";
  EXPECT_EQ(verdict(said), "confirmed");
  said["answer"]["overlap"] = 0.9;
  EXPECT_EQ(verdict(said), "refuted");
}

TEST(closed_form, unusable_input_is_refused_in_one_line) {
  Json said = claim(spheres, of_spheres, "none");
  said["bodies"][1]["shape"]["superellipsoid"]["semi_axes"] = {1, 0, 1};
  const SecondOpinions opinions = ask_second_opinion({claim(spheres, of_spheres, "none"), said});
  EXPECT_EQ(opinions.code, 2);
  EXPECT_NE(opinions.said[0].get<std::string>().find(".jsonl:2: bodies[1].semi_axes: must be above 0"),
            std::string::npos)
      << opinions.said[0];
}

/// The overlap in a direction by support functions: of the spheres 1 + 0.5 - 1.25 cos.
TEST(closed_form, by_hand_in_python) {
  if (run("python3 -V 2>&1").code != 0) GTEST_SKIP() << "needs python3";
  const fs::path file = fs::temp_directory_path() / ("plumb-by-hand-" + std::to_string(::getpid()) + ".json");
  const auto by_hand = [&](const Json& bodies, const std::string& directions) {
    write_file(file, Json{{"bodies", bodies}}.dump());
    return run("python3 -B " PLUMB_SOURCE_DIR "/properties/second_opinion/by_hand.py " + file.string() + " " +
               directions)
        .out;
  };
  EXPECT_EQ(by_hand(spheres, "'1 0 0' '0 0 2' '-1 0 0'"), "1 0 0 0.25\n0 0 2 1.5\n-1 0 0 2.75\n");
  EXPECT_EQ(by_hand(ellipsoids, "'0 0 1'"), "0 0 1 -0.5\n");
  Json turned = boxes;
  turned[1]["orientation"]["quaternion_wxyz"] = {2, 0, 0, 2};  // a quarter turn about z: the same body
  EXPECT_EQ(by_hand(turned, "'0 0 1'"), by_hand(boxes, "'0 0 1'"));
  EXPECT_EQ(by_hand(boxes, "'0 0 1'"), "0 0 1 0.125\n");
  fs::remove(file);
}

}  // namespace
}  // namespace plumb
