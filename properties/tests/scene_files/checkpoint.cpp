// Checkpoints come back bit for bit; whatever is damaged is refused, with the file's name and in one line.
#include "corpus/scene/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "corpus/case/case.hpp"

namespace plumb::scene {
namespace {

Checkpoint sample_checkpoint() {
  Checkpoint out;
  out.key = 0xfedcba9876543210U;
  out.snapshot.step = 123456789012;
  out.snapshot.totals = {1, 2, 3, 4};
  out.snapshot.pairs = {{0, 1}, {2, 7}};
  out.snapshot.columns = {{"position", {1, -0.0, 1e-310, std::numeric_limits<double>::quiet_NaN()}}, {"empty", {}}};
  out.lengths = {{"dump.lammpstrj", 17}, {"vtk/bodies.pvd", 0}};
  out.seconds = {{"solver", 0.125}};
  out.record = "{\"cases\": {}}";
  return out;
}

std::string damage_of(const std::string& bytes) {
  try {
    (void)parse_checkpoint(bytes, "c.bin");
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "none";
}

TEST(Checkpoints, ComeBackBitForBit) {
  const std::string bytes = format_checkpoint(sample_checkpoint());
  const Checkpoint again = parse_checkpoint(bytes, "c.bin");
  EXPECT_EQ(format_checkpoint(again), bytes);
  EXPECT_EQ(again.key, 0xfedcba9876543210U);
  EXPECT_EQ(again.snapshot.step, 123456789012);
  EXPECT_EQ(again.snapshot.pairs, sample_checkpoint().snapshot.pairs);
  EXPECT_EQ(again.snapshot.columns[0].first, "position");
  EXPECT_TRUE(std::signbit(again.snapshot.columns[0].second[1]));
  EXPECT_EQ(again.lengths, sample_checkpoint().lengths);
}

TEST(Checkpoints, AnyBytesLessIsDamage) {
  const std::string bytes = format_checkpoint(sample_checkpoint());
  for (std::size_t size = 24; size < bytes.size(); ++size)
    ASSERT_EQ(damage_of(bytes.substr(0, size)), "c.bin: is damaged: its checksum does not fit, or its end is missing")
        << size;
  EXPECT_EQ(damage_of(bytes + "x"), "c.bin: is damaged: its checksum does not fit, or its end is missing");
}

TEST(Checkpoints, AnyBitTurnedIsDamage) {
  const std::string bytes = format_checkpoint(sample_checkpoint());
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    const std::string error = damage_of(damaged);
    ASSERT_TRUE(error.starts_with("c.bin: is ") || error.starts_with("c.bin: version: is ")) << place << " " << error;
  }
}

TEST(Checkpoints, OtherFilesAndVersionsAreNamed) {
  EXPECT_EQ(damage_of(""), "c.bin: is no checkpoint of plumb, or its beginning is damaged");
  EXPECT_EQ(damage_of("{}"), "c.bin: is no checkpoint of plumb, or its beginning is damaged");
  std::string other = format_checkpoint(sample_checkpoint());
  other[16] = 3;
  EXPECT_EQ(damage_of(other), "c.bin: version: is 3, must be 2");
}

/// The checksum of what was changed, as whoever changes it may well put there.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t sum = hash_of_text(bytes);
  for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(sum >> (8 * byte) & 255);
  return bytes;
}

std::string changed(Checkpoint checkpoint, const std::function<void(Checkpoint&)>& change) {
  change(checkpoint);
  return format_checkpoint(checkpoint);
}

TEST(Checkpoints, ASpoiltFieldUnderAChecksumThatFitsIsNamed) {
  const Checkpoint sample = sample_checkpoint();
  const auto damage = [&](const std::function<void(Checkpoint&)>& change) {
    return damage_of(changed(sample, change));
  };
  EXPECT_EQ(damage([](Checkpoint& c) { c.seconds = {{"sol\xffver", 1}}; }),
            "c.bin: seconds: holds a name that no run has");
  EXPECT_EQ(damage([](Checkpoint& c) { c.seconds = {{"solver", std::nan("")}}; }),
            "c.bin: seconds: must be finite and not below 0");
  EXPECT_EQ(damage([](Checkpoint& c) { c.lengths = {{"\n", 1}}; }), "c.bin: lengths: holds a name that no run has");
  EXPECT_EQ(damage([](Checkpoint& c) { c.snapshot.columns = {{"\x80", {}}}; }),
            "c.bin: snapshot.columns: holds a name that no run has");
  EXPECT_EQ(damage([](Checkpoint& c) { c.snapshot.step = -1; }),
            "c.bin: snapshot.step: must be a whole number from 0 to 2^53");
  EXPECT_EQ(damage([](Checkpoint& c) { c.snapshot.totals.lists = std::numeric_limits<std::int64_t>::max(); }),
            "c.bin: snapshot.totals: must be a whole number from 0 to 2^53");
  const std::string bytes = format_checkpoint(sample);
  EXPECT_EQ(damage_of(sealed(bytes.substr(0, bytes.size() - 9) + std::string(8, ' '))),
            "c.bin: record: ends too early");
  EXPECT_EQ(damage_of(sealed(bytes + "x")), "c.bin: record: is longer than it may be");
}

TEST(Checkpoints, NoneIsNone) {
  EXPECT_FALSE(read_checkpoint("/nonexistent/checkpoint.bin").has_value());
}

}  // namespace
}  // namespace plumb::scene
