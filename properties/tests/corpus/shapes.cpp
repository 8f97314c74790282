// Cases of every shape: read and written bit for bit, refused in one line, and what the commands do with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "corpus/case/case.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb::shape_cases {
namespace {

const std::string ball = R"({"superellipsoid": {"semi_axes": [1.0, 1.0, 1.0], "exponents": [2.0, 2.0]}})";

std::string body_of(const std::string& shape, const std::string& z) {
  return R"({"shape": )" + shape + R"(, "position": [0.0, 0.0, )" + z +
         R"(], "orientation": {"quaternion_wxyz": [1.0, 0.0, 0.0, 0.0]}})";
}

/// As it is written: the shape at the origin, a ball of radius 1 above it.
std::string case_of(const std::string& shape, const std::string& above = ball, const std::string& format = "2") {
  return R"({"format": "plumb/case-)" + format + R"(", "name": "sample", "bodies": [)" + body_of(shape, "0.0") + ", " +
         body_of(above, "1.5") + "]}";
}

Case parsed(const std::string& text) {
  return parse_case(text, "a.jsonl", 7, CaseShapes::every);
}

std::string error_of(const std::string& text, CaseShapes shapes = CaseShapes::every) {
  try {
    (void)parse_case(text, "a.jsonl", 7, shapes);
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "none";
}

/// Shapes with numbers that no short decimal is, and a swept one.
const std::map<std::string, std::string> every_shape{
    {"capsule", R"({"capsule": {"half_length": 0.30000000000000004, "radius": 5e-324}})"},
    {"cylinder", R"({"cylinder": {"half_length": 1e-300, "radius": 1e+300}})"},
    {"cone", R"({"cone": {"radius": 0.1, "height": 2.0}})"},
    {"frustum", R"({"frustum": {"radii": [0.0, 0.1], "height": 2.0}})"},
    {"box", R"({"box": {"half_extents": [0.1, 0.2, 0.30000000000000004]}})"},
    {"polyhedron",
     R"({"polyhedron": {"points": [[0.1, -0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.3], [-1.0, -1.0, -1.0]]}})"},
    {"poly_superellipsoid",
     R"({"poly_superellipsoid": {"semi_axes": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], "exponents": [8.0, 2.5]}})"},
    {"half_space", R"({"half_space": {}})"},
    {"sphere_swept", R"({"sphere_swept": {"core": {"box": {"half_extents": [1.0, 2.0, 3.0]}}, "radius": 0.1}})"}};

TEST(Shapes, EveryShapeReadsBackToTheSameBits) {
  for (const auto& [word, shape] : every_shape) {
    const Case c = parsed(case_of(shape));
    ASSERT_TRUE(c.convex) << word;
    const std::string written = format_case(c);
    EXPECT_EQ(Json::parse(written), Json::parse(case_of(shape)));
    EXPECT_NE(written.find(write_json(Json::parse(shape))), std::string::npos) << written;
    EXPECT_EQ(format_case(parsed(written)), written);
  }
}

/// A legal one with the fields that its row has, each half of the one before.
template <class S>
Shape sample() {
  if constexpr (std::is_same_v<S, Polyhedron>)
    return make_polyhedron(std::array<Vec3<double>, 1>{Vec3<double>(1, 2, 3)});
  else
    return sample_of<S>();
}
template <class... S>
std::vector<Shape> samples(const std::variant<S...>* /*list*/) {
  std::vector<Shape> out;
  ((is_value<S> ? out.push_back(sample<S>()) : void()), ...);
  return out;
}

TEST(Shapes, WhatIsWrittenOfAnyReadsBack) {
  const ConvexBody above{Box{{1, 1, 1}}, 0, {0, 0, 1}, {1, 0, 0, 0}};
  for (const Shape& shape : samples(static_cast<const Shape*>(nullptr))) {
    const ConvexPair pair{{shape, 0.25}, above};
    Case written;
    written.convex = pair;
    const Case read = parsed(format_case(written));
    ASSERT_TRUE(read.convex) << name(shape);
    const ConvexBody body = read.convex.value_or(ConvexPair{}).body1;
    EXPECT_EQ(name(body.shape), name(shape));
    EXPECT_EQ(bounding_radius(body), bounding_radius(pair.body1)) << name(shape);
    EXPECT_EQ(format_case(read), format_case(written));
  }
}

TEST(Shapes, RadiiOfSweepsAddUp) {
  const Case c = parsed(case_of(
      R"({"sphere_swept": {"core": {"sphere_swept": {"core": {"half_space": {}}, "radius": 0.25}}, "radius": 0.5}})"));
  EXPECT_EQ(c.convex.value_or(ConvexPair{}).body1.swept_radius, 0.75);
  EXPECT_NE(format_case(c).find(R"({"sphere_swept": {"core": {"half_space": {}}, "radius": 0.75}})"),
            std::string::npos);
}

TEST(Shapes, OfAPolyhedronItsCornersAreKept) {
  const Case c = parsed(case_of(
      R"({"polyhedron": {"points": [[1, 0, 0], [0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [1, 0, 0]]}})"));
  EXPECT_NE(format_case(c).find(R"("points": [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]])"),
            std::string::npos)
      << format_case(c);
}

TEST(Shapes, TwoSuperellipsoidsAreAPairInEitherFormat) {
  const Case one = parsed(case_of(ball, ball, "1")), two = parsed(case_of(ball, ball, "2"));
  EXPECT_FALSE(two.convex);
  EXPECT_EQ(format_case(one), format_case(two));
  EXPECT_NE(format_case(two).find("plumb/case-1"), std::string::npos);
}

struct Refusal {
  std::string text, line;
};

TEST(Shapes, WhatIsWrongIsOneLine) {
  const std::string box = R"({"box": {"half_extents": [1, 1, 1]}})", half_space = R"({"half_space": {}})";
  const std::string with_motion = case_of(box).substr(0, case_of(box).size() - 1) + R"(, "motion": [0, 0, 1]})";
  std::string which = "must hold one of sphere_swept";
  for (const Shape& shape : samples(static_cast<const Shape*>(nullptr))) which += ", " + std::string(name(shape));
  const std::string too_far = "the bounding radius, to the farthest point, must be finite";
  const auto swept = [](const std::string& core, const std::string& radius) {
    return R"({"sphere_swept": {"core": )" + core + R"(, "radius": )" + radius + "}}";
  };
  const std::vector<Refusal> refusals{
      {case_of(box, ball, "1"), R"(bodies[0].shape: is no superellipsoid: takes "format": "plumb/case-2")"},
      {case_of(ball, box, "1"), R"(bodies[1].shape: is no superellipsoid: takes "format": "plumb/case-2")"},
      {case_of(box, ball, "3"), "format: must be one of plumb/case-1, plumb/case-2"},
      {case_of(R"({"boxes": {}})"), "bodies[0].shape: " + which},
      {case_of(box, R"({"boxes": {}})"), "bodies[1].shape: " + which},
      {case_of(R"({"boxes": {}})", ball, "1"), "bodies[0].shape.boxes: unknown field"},
      {case_of("1"), "bodies[0].shape: must be an object, not a number"},
      {case_of(R"({"box": {"half_extents": [1, 1, 1], "radius": 1}})"), "bodies[0].shape.box.radius: unknown field"},
      {case_of(R"({"box": {}})"), "bodies[0].shape.box.half_extents: missing"},
      {case_of(R"({"box": {"half_extents": [1, 1]}})"),
       "bodies[0].shape.box.half_extents: must be an array of 3 numbers, not 2"},
      {case_of(R"({"box": {"half_extents": [1, 1, 0]}})"),
       "bodies[0].shape.box.half_extents[2]: must be finite and above 0"},
      {case_of(R"({"capsule": {"half_length": -1, "radius": 1}})"),
       "bodies[0].shape.capsule.half_length: must be finite and not below 0"},
      {case_of(R"({"frustum": {"radii": [0, 0], "height": 1}})"), "bodies[0].shape.frustum.radii: must not both be 0"},
      {case_of(R"({"polyhedron": {"points": []}})"), "bodies[0].shape.polyhedron.points: a polyhedron needs a point"},
      {case_of(R"({"polyhedron": {"points": [[1, 2]]}})"),
       "bodies[0].shape.polyhedron.points[0]: must be an array of 3 numbers, not 2"},
      {case_of(R"({"sphere_swept": {"core": {"cone": {"radius": 0, "height": 1}}, "radius": 1}})"),
       "bodies[0].shape.sphere_swept.core.cone.radius: must be finite and above 0"},
      {case_of(R"({"sphere_swept": {"core": {"half_space": {}}, "radius": -1}})"),
       "bodies[0].shape.sphere_swept.radius: must not be negative"},
      {case_of(R"({"box": {"half_extents": [1, 1, 1]}, "half_space": {}})"), "bodies[0].shape: " + which},
      {case_of(swept(swept(half_space, "1e308"), "1e308")),
       "bodies[0].shape.sphere_swept.radius: the radii add up to infinity"},
      {case_of(swept(swept(R"({"capsule": {"half_length": 1e308, "radius": 1}})", "5e307"), "5e307")),
       "bodies[0].shape.sphere_swept.radius: " + too_far},
      {case_of(swept(R"({"box": {"half_extents": [1.7e308, 1.7e308, 1]}})", "1")),
       "bodies[0].shape.sphere_swept.core.box: " + too_far},
      {case_of(half_space, half_space), "bodies[1].shape.half_space: two half-spaces have no lowest overlap"},
      {with_motion, "motion: is for two superellipsoids"}};
  for (const auto& [text, line] : refusals) EXPECT_EQ(error_of(text), "a.jsonl:7: " + line);
}

TEST(Shapes, WhoDoesNotAskForThemGetsNone) {
  for (const auto& [word, shape] : every_shape)
    EXPECT_EQ(
        error_of(case_of(shape), CaseShapes::superellipsoids),
        "a.jsonl:7: bodies[0].shape: is no superellipsoid: not taken here (plumb solve, certify, check and replay "
        "take it)");
}

TEST_F(Commands, EveryOtherReaderRefusesAShapeInOneLine) {
  (void)file("a.json", case_of(R"({"box": {"half_extents": [1, 1, 1]}})"));
  const std::string line =
      "a.json: bodies[0].shape: is no superellipsoid: not taken here (plumb solve, certify, check and replay take it)";
  for (const char* arguments : {"path a.json --method auto", "certify a.json --problem midway"})
    expect_refusal(arguments, line);
  expect_refusal("certify a.json --all", "a.json: bodies: --all, --effort and --proof are for superellipsoids");
  expect_refusal("solve a.json --method new_cn", "a.json: bodies: new_cn takes superellipsoids alone");
}

TEST_F(Commands, AFileMayHoldBothFormats) {
  (void)file("a.jsonl", case_of(ball, ball, "1") + "\n" + case_of(R"({"box": {"half_extents": [1, 1, 1]}})") + "\n");
  const std::vector<Json> answers = lines_of(plumb("solve a.jsonl --json").out);
  ASSERT_EQ(answers.size(), 2U);
  for (const Json& answer : answers) {
    EXPECT_EQ(answer["method"], "auto");
    EXPECT_EQ(answer["status"], "converged");
    EXPECT_NEAR(answer["overlap"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(answer["normal"][2].get<double>(), 1, 1e-12);
  }
  EXPECT_TRUE(answers[0].contains("residuals"));
  EXPECT_FALSE(answers[1].contains("residuals"));
  // Who takes superellipsoids alone is not asked.
  EXPECT_EQ(lines_of(plumb("solve a.jsonl --json --method new_cn,auto").out).size(), 3U);
}

TEST_F(Commands, BoundsOfAShapeAreCertified) {
  (void)file("a.json", case_of(R"({"box": {"half_extents": [1, 1, 1]}})"));
  const Ran ran = plumb("certify a.json --digits 17 --json");
  EXPECT_EQ(ran.code, 0);
  const Json certificate = lines_of(ran.out).at(0);
  EXPECT_EQ(certificate["verdict"], "overlapping");
  EXPECT_LE(std::stod(certificate["overlap"]["lower"].get<std::string>()), 0.5);
  EXPECT_GE(std::stod(certificate["overlap"]["upper"].get<std::string>()), 0.5);
  EXPECT_EQ(certificate["unique"], "open");
  EXPECT_FALSE(certificate.contains("normal"));
  EXPECT_FALSE(certificate.contains("digits"));  // the bounds are doubles
}

TEST_F(Commands, AnswersToAShapeAreJudged) {
  (void)file("a.json", case_of(R"({"box": {"half_extents": [1, 1, 1]}})"));
  const std::string right = R"({"overlap": 0.5, "normal": [0, 0, 1], "points": [[0, 0, 1], [0, 0, 0.5]]})";
  const std::map<std::string, std::string> judged{
      {right, "none"},
      {R"({"overlap": 0.5})", "none"},
      {R"({"overlap": 0.6})", "overlap_error"},
      {R"({"overlap": -0.5})", "missed_contact"},
      {R"({"status": "stalled"})", "nonconverged"},
      {R"({"overlap": 3.5, "normal": [0, 0, -1], "points": [[0, 0, -1], [0, 0, 2.5]]})", "wrong_branch"},
      {R"({"overlap": 0.5, "normal": [0, 0.6, 0.8], "points": [[0, 0, 1], [0, 0, 0.5]]})", "misaligned"},
      {R"({"overlap": 0.4, "normal": [0, 0, 1], "points": [[0, 0, 1], [0, 0, 0.6]]})", "off_surface"}};
  for (const auto& [answer, finding] : judged) {
    (void)file("b.json", answer);
    const Ran ran = plumb("check a.json --answer b.json");
    EXPECT_EQ(ran.code, finding == "none" ? 0 : 1) << answer;
    EXPECT_EQ(lines_of(ran.out).at(0)["finding"], finding) << answer;
  }
  (void)file("b.json", R"({"method": "midway", "overlap": 0.5})");
  expect_refusal("check a.json --answer b.json", "b.json: method: midway is for superellipsoids");
}

TEST_F(Commands, AShapeIsReplayed) {
  const std::string text = case_of(R"({"box": {"half_extents": [1, 1, 1]}})");
  const auto expecting = [&](const std::string& expect) {
    return text.substr(0, text.size() - 1) + R"(, "expect": )" + expect + "}";
  };
  (void)file("same.json", expecting(R"({"verdict": "overlapping", "overlap": [0.49, 0.51], "normal": [0, 0, 1]})"));
  EXPECT_EQ(plumb("replay same.json").code, 0);
  (void)file("other.json", expecting(R"({"overlap": [0.6, 0.7]})"));
  EXPECT_EQ(plumb("replay other.json").code, 1);
  const Ran not_asked = plumb("replay same.json --method new_cn");
  EXPECT_EQ(not_asked.code, 0);
  EXPECT_NE(not_asked.out.find("not asked"), std::string::npos) << not_asked.out;
}

TEST_F(Commands, TheShapesOfTheCorpusAreAsTheyWereWorkedOutByHand) {
  const Ran ran = plumb("replay " PLUMB_SOURCE_DIR "/corpus/cases/shapes --quiet");
  EXPECT_EQ(ran.code, 0) << ran.out;
}

}  // namespace
}  // namespace plumb::shape_cases
