// Every finding that the recorder knows, planted: seen, named as the laws name it, kept once.
#include <cmath>
#include <functional>

#include "corpus/case/answer.hpp"
#include "properties/tests/recorder/sample.hpp"

namespace plumb {
namespace {

struct Planted {
  std::string finding;
  std::function<void(Pair&, Contact<double>&)> spoil;
};

void say_apart(Contact<double>& contact) {
  contact = {};
  contact.status = Status::converged;
  contact.verdict = Verdict::separated;
}

/// The far sides of two spheres have common normals as well: the highest.
void take_far_sides(Pair& pair, Contact<double>& contact) {
  pair.body1.shape = pair.body2.shape = {{1, 1, 1}, 2, 2};
  const Vec3<double> apart = pair.body2.position - pair.body1.position, line = apart.normalized();
  contact.normal = -line;
  contact.point1 = pair.body1.position - line;
  contact.point2 = pair.body2.position + line;
  contact.overlap = 2 + apart.norm();
}

void tilt(Contact<double>& contact) {
  contact.normal = (contact.normal + Vec3<double>(1e-3, -1e-3, 1e-3)).normalized();
}

/// Of spheres, whose normals stay.
void shift_points(Pair& pair, Contact<double>& contact) {
  pair.body1.shape = pair.body2.shape = {{1, 1, 1}, 2, 2};
  contact = answer_of("auto", pair);
  contact.point1 += 1e-3 * contact.normal;
  contact.point2 += 1e-3 * contact.normal;
}

std::vector<Planted> all_planted() {
  return {{"false_contact", [](Pair& pair, Contact<double>&) { pair.body2.position *= 2; }},
          {"missed_contact", [](Pair&, Contact<double>& contact) { say_apart(contact); }},
          {"wrong_branch", take_far_sides},
          {"misaligned", [](Pair&, Contact<double>& contact) { tilt(contact); }},
          {"off_surface", shift_points},
          {"overlap_error", [](Pair&, Contact<double>& contact) { contact.overlap *= 1.01; }}};
}

class RecorderFindings : public Folder {};

TEST_F(RecorderFindings, ArePlantedSeenNamedAsTheLawsDoAndKeptOnce) {
  open();
  for (const auto& [finding, spoil] : all_planted()) {
    Pair pair = deep_pair();
    Contact<double> contact = answer_of("auto", pair);
    spoil(pair, contact);
    const Recorded call = recorded(pair, contact);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(plumb_recorder_finding_name(call.give_to(recorder_)), finding);
    Judge judge(pair);
    EXPECT_EQ(name(judge.judge(Problem::common_normal, contact).finding.kind), finding);
  }
  EXPECT_EQ(kept().size(), all_planted().size());
  EXPECT_EQ(counts().files, all_planted().size());
  EXPECT_EQ(counts().wrong, 5 * all_planted().size());
  const Ran ran = plumb("replay kept");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_NE(ran.out.find("same  recorded  misaligned  "), std::string::npos) << ran.out;
}

TEST_F(RecorderFindings, WhatIsNoNumberIsNotFinite) {
  open();
  const Pair pair = deep_pair();
  const Contact<double> right = answer_of("auto", pair);
  for (const double value : {std::nan(""), HUGE_VAL}) {
    Recorded call = recorded(pair, right);
    call.answer.normal[1] = value;
    EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_NOT_FINITE);
  }
  EXPECT_EQ(kept().size(), 1U);
  EXPECT_EQ(plumb("replay kept").code, 0);
}

TEST_F(RecorderFindings, WhatTheCodeLacksIsNoFinding) {
  plumb_recorder_options options = plumb_recorder_defaults();
  options.lacks = PLUMB_LACKS_POINTS;
  open(options);
  const Pair pair = deep_pair();
  Recorded call = recorded(pair, answer_of("auto", pair));
  call.answer.points[0][0] = call.answer.points[1][2] = std::nan("");
  EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_NOTHING);
  EXPECT_EQ(counts().not_judged, 0U);
  call.answer.overlap *= 1.01;
  EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR);
}

/// Unit spheres 1 apart.
Recorded apart(double overlap, const Vec3<double>& normal) {
  Pair pair;
  pair.body1.shape = pair.body2.shape = {{1, 1, 1}, 2, 2};
  pair.body2.position = {3, 0, 0};
  Contact<double> contact;
  say_apart(contact);
  contact.overlap = overlap;
  contact.normal = normal;
  return recorded(pair, contact);
}

TEST_F(RecorderFindings, WhatIsSaidOfBodiesApartIsJudged) {
  const double nan = std::nan("");
  const Vec3<double> none(nan, nan, nan), line(1, 0, 0), across(0, 1, 0);
  open();
  for (const Recorded& right : {apart(nan, none), apart(-1, none), apart(-1, line), apart(nan, line)})
    EXPECT_EQ(right.give_to(recorder_), PLUMB_FOUND_NOTHING);
  EXPECT_EQ(apart(-99, across).give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR);
  for (const double overlap : {-99.0, -1.01, -0.99, 5.0})
    EXPECT_EQ(apart(overlap, none).give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR) << overlap;
  Recorded half = apart(-1, line);
  half.answer.points[1][2] = 0;
  EXPECT_EQ(half.give_to(recorder_), PLUMB_FOUND_NOT_FINITE);
  EXPECT_EQ(counts().not_judged, 0U);
  const Ran ran = plumb("replay kept");
  EXPECT_EQ(ran.code, 0) << ran.out;
}

/// A contact has no distance, and the highest common normal of bodies apart is a wrong one.
TEST_F(RecorderFindings, ASignAgainstTheVerdictIsAnError) {
  open();
  Recorded touching = recorded(deep_pair(), answer_of("auto", deep_pair()));
  std::fill_n(touching.answer.normal, 3, std::nan(""));
  std::fill_n(touching.answer.points[0], 6, std::nan(""));
  touching.answer.overlap = -5;
  plumb_recorder_options bare = plumb_recorder_defaults();
  bare.lacks = PLUMB_LACKS_NORMAL | PLUMB_LACKS_POINTS;
  open(bare);
  EXPECT_EQ(touching.give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR);
  Recorded far = apart(5, Vec3<double>(-1, 0, 0));
  const double points[6] = {-1, 0, 0, 4, 0, 0};
  std::copy_n(points, 6, far.answer.points[0]);
  open();
  EXPECT_EQ(far.give_to(recorder_), PLUMB_FOUND_WRONG_BRANCH);
  EXPECT_EQ(plumb("replay kept").code, 0);
}

TEST_F(RecorderFindings, PointsBeyondAllBoundsAreOffTheSurface) {
  open();
  Recorded call = recorded(deep_pair(), answer_of("auto", deep_pair()));
  for (const bool is_round : {true, false}) {
    if (is_round) std::copy_n(call.body1.shape, 5, call.body2.shape);
    if (!is_round) call.body2.shape[3] = 40;
    call.answer.overlap = 0;
    for (auto& point : call.answer.points) std::fill_n(point, 3, 1e160);
    EXPECT_NE(call.give_to(recorder_), PLUMB_FOUND_NOTHING);
  }
  Recorded spheres = apart(0, Vec3<double>(1, 1, 1).normalized());
  spheres.body2.pose[0] = 1.5, spheres.answer.touching = 1;
  for (auto& point : spheres.answer.points) std::fill_n(point, 3, 1e160);
  EXPECT_NE(spheres.give_to(recorder_), PLUMB_FOUND_NOTHING);
}

TEST_F(RecorderFindings, AToleranceThatIsNoneIsTheDefault) {
  const Recorded right = recorded(deep_pair(), answer_of("auto", deep_pair()));
  for (const double tolerance : {std::nan(""), -1.0, HUGE_VAL}) {
    plumb_recorder_options options = plumb_recorder_defaults();
    options.tolerance = tolerance;
    open(options);
    EXPECT_EQ(right.give_to(recorder_), PLUMB_FOUND_NOTHING);
    Recorded wrong = right;
    wrong.answer.overlap += 1e-3;
    EXPECT_EQ(wrong.give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR);
    EXPECT_EQ(json("kept/" + kept().at(0))["provenance"]["tolerance"], 1e-6);
    EXPECT_EQ(plumb("replay kept").code, 0);
    fs::remove_all(folder());
  }
}

TEST_F(RecorderFindings, NothingIsJudgedOfIllegalBodies) {
  open();
  const Pair pair = deep_pair();
  const Recorded right = recorded(pair, answer_of("auto", pair));
  std::vector<Recorded> illegal(4, right);
  illegal.push_back(apart(-1, Vec3<double>(1, 0, 0)));
  illegal.push_back(apart(std::nan(""), Vec3<double>::Constant(std::nan(""))));
  illegal[4].body1.shape[3] = illegal[5].body1.shape[3] = 0.5;
  illegal[0].body1.shape[1] = -1;
  illegal[1].body2.shape[3] = 1;
  illegal[2].body2.pose[0] = std::nan("");
  std::fill_n(illegal[3].body1.pose + 3, 4, 0.0);
  for (const Recorded& call : illegal) EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_NOTHING);
  EXPECT_EQ(counts().not_judged, illegal.size());
}

TEST_F(RecorderFindings, AnErrorWithinTheToleranceIsNoNews) {
  const Pair pair = deep_pair();
  Recorded call = recorded(pair, answer_of("auto", pair));
  call.answer.overlap += 1e-8;
  open();
  EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_NOTHING);
  plumb_recorder_options exact = plumb_recorder_defaults();
  exact.tolerance = 0;
  open(exact);
  EXPECT_EQ(call.give_to(recorder_), PLUMB_FOUND_OVERLAP_ERROR);
}

TEST_F(RecorderFindings, ANullRecorderDoesNothing) {
  const Pair pair = deep_pair();
  const Recorded call = recorded(pair, answer_of("auto", pair));
  plumb_recorder_begin(nullptr, &call.body1, &call.body2);
  EXPECT_EQ(call.give_to(nullptr), PLUMB_FOUND_NOTHING);
  EXPECT_EQ(plumb_recorder_counted(nullptr).calls, 0U);
  EXPECT_STREQ(plumb_recorder_problem(nullptr), "");
  plumb_recorder_close(nullptr);
}

/// Of plumb's families; the shape of a bucket's name is the corpus's own word.
TEST_F(RecorderFindings, CasesHoldTheBitsOfTheCall) {
  open();
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pair pair = generate("superquadric", 5, i).pair;
    Contact<double> contact = answer_of("auto", pair);
    contact.overlap = 1.0 / 3 + contact.overlap;
    (void)record(recorder_, pair, contact);
  }
  ASSERT_GT(kept().size(), 3U);
  for (const std::string& name : kept()) {
    const Case c = parse_case(read("kept/" + name), name);
    EXPECT_NE(name.find(shape_class(c.pair)), std::string::npos) << name;
    const Pair pair = generate("superquadric", 5, c.provenance["call"].get<std::uint64_t>() - 1).pair;
    EXPECT_EQ(bodies_json(c.pair), bodies_json(pair));
    const auto answer = recorded_answer(c, name);
    if (!answer) FAIL() << name;
    EXPECT_EQ(answer->given.contact.overlap, 1.0 / 3 + answer_of("auto", pair).overlap);
  }
}

}  // namespace
}  // namespace plumb
