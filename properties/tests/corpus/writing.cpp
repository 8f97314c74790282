// What is written reads back to the same bits, in the fewest digits, and never costs what was there before.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "corpus/case/answer.hpp"
#include "corpus/case/case.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/corpus/sample.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// Nothing but the bits: -0 and 0 differ.
std::vector<std::uint64_t> bits_of(const Pair& pair) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const Body* body : {&pair.body1, &pair.body2}) {
    for (const double x : body->shape.semi_axes) add(x);
    add(body->shape.n1);
    add(body->shape.n2);
    for (const double x : body->position) add(x);
    for (const double x : body->quaternion) add(x);
  }
  return bits;
}

RC_GTEST_PROP(Writing, EveryCaseOfTheFamiliesReadsBackToTheSameBits, ()) {
  const std::string family(*rc::gen::element<std::string_view>("spheroid", "ellipsoid", "superquadric", "hard"));
  const Case c = *generators::case_of(family);
  const Case back = parse_case(format_case(c), "a.json");
  RC_ASSERT(bits_of(back.pair) == bits_of(c.pair));
  RC_ASSERT(back.name == c.name);
  RC_ASSERT(format_case(back) == format_case(c));
}

/// Any bit pattern that is a finite number.
double finite(std::uint64_t bits) {
  const double x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : 1.0;
}

RC_GTEST_PROP(Writing, EveryDoubleReadsBackToTheSameBits, (std::uint64_t bits)) {
  const double x = finite(bits);
  const Json back = read_json(write_json(Json(x)));
  RC_ASSERT(std::bit_cast<std::uint64_t>(back.get<double>()) == std::bit_cast<std::uint64_t>(x));
}

long digits_in(const std::string& text) {
  return std::count_if(text.begin(), std::find(text.begin(), text.end(), 'e'),
                       [](char c) { return c >= '0' && c <= '9'; });
}

RC_GTEST_PROP(Writing, NoShorterDecimalReadsBack, (std::uint64_t bits)) {
  const double x = finite(bits);
  std::array<char, 64> buffer{};
  const std::string scientific(buffer.data(),
                               std::to_chars(buffer.begin(), buffer.end(), x, std::chars_format::scientific).ptr);
  const long digits = digits_in(scientific);
  RC_ASSERT(shortest(x).size() <= scientific.size());
  (void)std::snprintf(buffer.data(), buffer.size(), "%.*e", static_cast<int>(std::max(digits - 2, 0L)), x);
  RC_ASSERT(digits == 1 || std::strtod(buffer.data(), nullptr) != x);
}

TEST(Writing, ExtremesKeepTheirBits) {
  for (const double x : {-0.0, 0.0, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e22, 1e300, 0.1, -1.0})
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read_json(shortest(x)).get<double>()), std::bit_cast<std::uint64_t>(x)) << x;
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1), "1");
  EXPECT_EQ(shortest(5e-324), "5e-324");
}

TEST(Writing, ExpectationsAndMotionReadBack) {
  const std::string fields =
      R"("motion": [1, 2, 3], "expect": {"method": "new_cn", "status": "converged", )"
      R"("verdict": "overlapping", "finding": "none", "overlap": [0.5, 0.6], "normal": [1, 0, 0], )"
      R"("normal_radius": 0.001, "points": [[1, 0, 0], [0.5, 0, 0]]})";
  const std::string line = format_case(parse_case(sample_plus(fields), "a.json"));
  EXPECT_NE(line.find(fields), std::string::npos) << line;
  EXPECT_EQ(format_case(parse_case(line, "a.json")), line);
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

TEST(Writing, FieldsThatAreNotValidAreAbsent) {
  Answer answer{"name", parse_case(sample_case(), "a.json").pair, {}, {}, {}};
  answer.contact.method = "none";
  EXPECT_EQ(write_json(answer_json(answer)),
            R"({"name": "name", "method": "none", "status": "stalled", "verdict": "undecided", "iterations": 0, )"
            R"("evaluations": 0})");
}

TEST(Writing, AnswersReadBack) {
  Answer answer{"name", parse_case(sample_case(), "a.json").pair, {}, {}, 12.0};
  answer.contact.method = "new_cn";
  answer.contact.status = Status::converged;
  answer.contact.verdict = Verdict::overlapping;
  answer.contact.overlap = 0.5;
  answer.contact.normal = {1, 0, 0};
  answer.contact.point1 = {1, 0, 0};
  answer.contact.point2 = {0.5, 0, 0};
  const GivenAnswer back = parse_answer(write_json(answer_json(answer)), "a.json");
  EXPECT_EQ(back.method, "new_cn");
  EXPECT_EQ(back.contact.status, Status::converged);
  EXPECT_EQ(back.contact.overlap, 0.5);
  EXPECT_EQ(back.contact.point2, answer.contact.point2);
  EXPECT_TRUE(std::isnan(back.contact.contact_point[0]));
}

TEST(Writing, AnAnswerWithoutWordsVouchesForItself) {
  const GivenAnswer answer = parse_answer(R"({"overlap": -0.1, "normal": null, "x_colour": "red"})", "a.json");
  EXPECT_EQ(answer.contact.status, Status::converged);
  EXPECT_EQ(answer.contact.verdict, Verdict::separated);
  EXPECT_TRUE(std::isnan(answer.contact.normal[0]));
}

class Folder : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(path_); }
  void TearDown() override { fs::remove_all(path_); }
  [[nodiscard]] std::string text_of(const fs::path& file) const {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] long files() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }
  static std::string error_of(const fs::path& file) {
    try {
      write_file(file, "text");
    } catch (const InputFailure& error) {
      return error.what();
    }
    return "none";
  }

  fs::path path_ = fs::temp_directory_path() / ("plumb-writing-" + std::to_string(::getpid()));
};

TEST_F(Folder, ReplacesAFileAndLeavesNoTemporary) {
  write_file(path_ / "a", "one");
  write_file(path_ / "a", "two");
  EXPECT_EQ(text_of(path_ / "a"), "two");
  EXPECT_EQ(files(), 1);
}

TEST_F(Folder, FollowsASymbolicLink) {
  write_file(path_ / "a", "one");
  fs::create_symlink(path_ / "a", path_ / "link");
  write_file(path_ / "link", "two");
  EXPECT_EQ(text_of(path_ / "a"), "two");
  EXPECT_TRUE(fs::is_symlink(path_ / "link"));
}

TEST_F(Folder, NamesTheFileThatCannotBeWritten) {
  EXPECT_EQ(error_of(path_ / "none" / "a"), (path_ / "none" / "a").string() + ": No such file or directory");
  EXPECT_EQ(error_of("/dev/full"), "/dev/full: No space left on device");
  EXPECT_EQ(error_of("/proc/a").substr(0, 9), "/proc/a: ");
  EXPECT_NE(error_of(path_), "none");
  EXPECT_TRUE(fs::is_directory(path_));
  EXPECT_EQ(files(), 0);
}

TEST_F(Folder, OwnDescriptorsAreWrittenTo) {
  const int file = ::open((path_ / "a").c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(::write(file, "one ", 4), 4);
  write_file("/dev/fd/" + std::to_string(file), "two ");
  ASSERT_EQ(::write(file, "three", 5), 5);
  ::close(file);
  EXPECT_EQ(text_of(path_ / "a"), "one two three");
  EXPECT_EQ(error_of("/dev/fd/" + std::to_string(file)), "/dev/fd/" + std::to_string(file) + ": Bad file descriptor");
}

TEST_F(Folder, CaseFilesAreFoundInOrder) {
  for (const char* name : {"b.json", "a.jsonl", "notes.txt", "summary.json"}) write_file(path_ / name, "");
  fs::create_directory(path_ / "c");
  write_file(path_ / "c" / "d.json", "");
  const auto found = find_case_files({path_.string()});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].filename(), "a.jsonl");
  EXPECT_EQ(found[1].filename(), "b.json");
  EXPECT_EQ(found[2].filename(), "d.json");
  EXPECT_THROW((void)find_case_files({(path_ / "none").string()}), InputFailure);
}

TEST_F(Folder, CasesBeforeABadLineAreHandedOut) {
  write_file(path_ / "a.jsonl", sample_case() + "\n\n" + sample_case() + "\n{}\n");
  CaseReader reader((path_ / "a.jsonl").string());
  EXPECT_TRUE(reader.next().has_value());
  EXPECT_TRUE(reader.next().has_value());
  EXPECT_EQ(reader.line(), 3);
  EXPECT_THROW((void)reader.next(), InputFailure);
}

}  // namespace
}  // namespace plumb
