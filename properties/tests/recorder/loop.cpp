// One wrong contact among ten million right ones, and the example of the documentation.
#include "corpus/json/fields.hpp"
#include "properties/tests/recorder/sample.hpp"

namespace plumb {
namespace {

class RecorderLoop : public Folder {};

std::vector<Recorded> right_ones() {
  std::vector<Recorded> out;
  for (std::uint64_t i = 0; out.size() < 4000; ++i) {
    const Pair pair = generate("ellipsoid", 3, i).pair;
    const Contact<double> contact = answer_of("auto", pair);
    if (contact.status == Status::converged) out.push_back(recorded(pair, contact));
  }
  return out;
}

TEST_F(RecorderLoop, OneWrongAmongTenMillionIsKeptAndReplays) {
  constexpr std::uint64_t calls = 10'000'000, planted = 6'789'012;
  const std::vector<Recorded> right = right_ones();
  Recorded wrong = right[planted % right.size()];
  wrong.answer.normal[0] += 1e-3;
  open();
  std::uint64_t found = 0;
  for (std::uint64_t i = 0; i < calls; ++i)
    found += (i == planted ? wrong : right[i % right.size()]).give_to(recorder_) == 0 ? 0 : 1;
  EXPECT_EQ(found, 1U);
  EXPECT_EQ(counts().wrong, 1U);
  EXPECT_EQ(counts().calls, calls);
  ASSERT_EQ(kept().size(), 1U);
  EXPECT_EQ(parse_case(read("kept/" + kept()[0]), "kept").provenance["call"], planted + 1);
  const Ran ran = plumb("replay kept");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_TRUE(ran.out.starts_with("same  recorded  misaligned  ")) << ran.out;
}

TEST_F(RecorderLoop, ARecordedAnswerThatIsRightDiffers) {
  const Pair pair = deep_pair();
  Recorded call = recorded(pair, answer_of("auto", pair));
  call.answer.normal[0] += 1e-3;
  (void)call.give_to(open());
  Json right = json("kept/" + kept().at(0));
  right["x_answer"]["normal"] = vector_json(answer_of("auto", pair).normal);
  (void)file("right.json", right.dump());
  const Ran ran = plumb("replay right.json");
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(ran.out.starts_with("DIFF  recorded  none  ")) << ran.out;
  EXPECT_TRUE(plumb("replay right.json --method auto").out.starts_with("same  auto  none  "));
  const std::string reason = "is a recorded answer: --method or --solver names who answers simpler cases";
  expect_refusal("shrink right.json", "right.json: x_answer: " + reason);
}

TEST_F(RecorderLoop, ARecordedAnswerIsReadAsStrictlyAsAny) {
  Json c = Json::parse(format_case({"a", deep_pair(), {}, {}, {}}));
  c["x_answer"] = {{"overlap", "deep"}};
  (void)file("a.json", c.dump());
  expect_refusal("replay a.json", "a.json: x_answer.overlap: must be a number, not a string");
  c["x_answer"] = {{"x_finding", "gone"}};
  (void)file("a.json", c.dump());
  EXPECT_EQ(plumb("replay a.json 2>&1").code, 2);
}

/// As the documentation shows it.
TEST_F(RecorderLoop, TheExampleRuns) {
  const Ran ran = run("cd " + path_.string() + " && " + PLUMB_BINARY_DIR + "/tests/recorder_example");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("misaligned"), std::string::npos) << ran.out;
  const Ran replay = plumb("replay wrong-contacts");
  EXPECT_EQ(replay.code, 0) << replay.out;
  EXPECT_NE(replay.out.find("same  recorded  misaligned  "), std::string::npos) << replay.out;
}

}  // namespace
}  // namespace plumb
