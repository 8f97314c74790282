// Warm starts in a batch: along a motion the answers of `auto`, warm; and a yes or no.
#include <gtest/gtest.h>

#include <span>

#include "properties/doors/columns.hpp"
#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/batch/batch.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// Pairs of a family that slide and turn, each in a way of its own.
class Moving {
 public:
  Moving(std::string_view family, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      pairs.push_back(generate(family, 23, i).pair);
      Stream stream("warm batch", 23, i);
      const double step = stream.log_uniform(1e-5, 3e-2);
      turns_.push_back(turn(random_direction(stream), step));
      shifts_.emplace_back(random_direction(stream) * (step * size_of(pairs.back()) * stream.uniform()));
    }
  }

  void step() {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs[i].body2.position += shifts_[i];
      pairs[i].body2.quaternion = product(turns_[i], pairs[i].body2.quaternion);
    }
  }

  std::vector<Pair> pairs;

 private:
  std::vector<Quaternion> turns_;
  std::vector<Vec3<double>> shifts_;
};

struct Step {
  ContactColumns contacts;
  std::size_t alone = 0;
};

/// The steps before, the newest last.
using Steps = std::span<const ContactColumns>;
const ContactColumns* step_before(Steps steps, std::size_t back) {
  return back <= steps.size() ? &steps[steps.size() - back] : nullptr;
}

/// What `auto` would start from.
Contact<double> start_of(Steps before, std::size_t i) {
  Contact<double> out = before.back().at(i);
  const ContactColumns *last = step_before(before, 2), *older = step_before(before, 3);
  if (last == nullptr) return out;
  out.last_chart1 = last->at(i).chart1;
  out.last_chart2 = last->at(i).chart2;
  if (older == nullptr) return out;
  out.bend1 = chart_bend(out.chart1, out.last_chart1, older->at(i).chart1);
  out.bend2 = chart_bend(out.chart2, out.last_chart2, older->at(i).chart2);
  return out;
}

/// From the charts of the steps before: of one, of two, or, with the bends, of three.
Step stepped(const std::vector<Pair>& pairs, InstructionSet set, Steps before = {}) {
  const PairColumns columns(pairs);
  PairArrays arrays = columns.arrays();
  BendColumns bends(pairs.size());
  if (const auto* step = step_before(before, 1)) arrays.last = step->charts();
  if (const auto* step = step_before(before, 2)) arrays.before_last = step->charts();
  if (before.size() > 2) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> start = start_of(before, i);
      bends.set(i, start.bend1, start.bend2);
    }
    arrays.bend = bends.arrays();
  }
  Step out{ContactColumns(pairs.size())};
  const BatchReport report = solve_batch(arrays, {}, out.contacts.arrays(), set);
  EXPECT_EQ(report.error, BatchError::none);
  out.alone = report.alone;
  return out;
}

double reach_of(const Pair& pair) {
  return std::max(size_of(pair), (pair.body2.position - pair.body1.position).norm());
}

/// Ellipsoids to the bit; others to what their exp and log differ by.
void expect_near(const Pair& pair, const Contact<double>& batch, const Contact<double>& alone, bool is_same) {
  ASSERT_EQ(batch.status, alone.status);
  if (alone.status != Status::converged) return;
  if (!is_same) {
    ASSERT_NEAR(batch.overlap, alone.overlap, 1e-14 * reach_of(pair));
    return;
  }
  ASSERT_EQ(batch.overlap, alone.overlap);
  ASSERT_EQ(batch.normal, alone.normal);
  ASSERT_EQ(batch.contact_point, alone.contact_point);
  ASSERT_EQ(batch.chart1, alone.chart1);
  ASSERT_EQ(batch.chart2, alone.chart2);
  ASSERT_EQ(batch.evaluations, alone.evaluations);
}

TEST(WarmBatch, FollowsMotionsAsAutoDoes) {
  const Method& method = *find_method("auto");
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric", "hard"})
    for (const InstructionSet set : available_instruction_sets()) {
      Moving moving(family, 130);
      std::vector<ContactColumns> steps{stepped(moving.pairs, set).contacts};
      for (int k = 0; k < 12; ++k) {
        moving.step();
        ContactColumns now = stepped(moving.pairs, set, steps).contacts;
        for (std::size_t i = 0; i < moving.pairs.size(); ++i) {
          const Contact<double> start = start_of(steps, i);
          SCOPED_TRACE(testing::Message() << family << ' ' << i << ", step " << k << ", " << name(set));
          const bool is_same = family == "spheroid" || family == "ellipsoid";
          expect_near(moving.pairs[i], now.at(i), method.solve(moving.pairs[i], {}, &start), is_same);
          if (HasFatalFailure()) return;
        }
        steps.push_back(std::move(now));
      }
    }
}

TEST(WarmBatch, EveryInstructionSetHasTheSameBits) {
  for (const std::string_view family : {"superquadric", "hard"}) {
    std::vector<ContactColumns> ends;
    for (const InstructionSet set : available_instruction_sets()) {
      Moving moving(family, 130);
      std::vector<ContactColumns> steps;
      for (int k = 0; k < 4; ++k, moving.step()) steps.push_back(stepped(moving.pairs, set, steps).contacts);
      ends.push_back(steps.back());
    }
    for (const ContactColumns& other : ends) {
      EXPECT_EQ(std::memcmp(other.overlap.data(), ends[0].overlap.data(), other.overlap.size() * sizeof(double)), 0);
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(std::memcmp(other.chart1[axis].data(), ends[0].chart1[axis].data(),
                              other.chart1[axis].size() * sizeof(double)),
                  0);
    }
  }
}

/// The charts of one pair alone.
ContactColumns charts_of(const ContactColumns& step, std::size_t i) {
  ContactColumns out(1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.chart1[axis][0] = step.chart1[axis][i];
    out.chart2[axis][0] = step.chart2[axis][i];
  }
  return out;
}

/// Some lanes have a start and a bend, some none, some those of another contact altogether.
TEST(WarmBatch, NoStartTouchesAnother) {
  for (const InstructionSet set : available_instruction_sets()) {
    Moving moving("superquadric", 130);
    std::vector<ContactColumns> steps;
    for (int k = 0; k < 3; ++k, moving.step()) steps.push_back(stepped(moving.pairs, set, steps).contacts);
    for (std::size_t i = 0; i < moving.pairs.size(); ++i)
      for (auto* chart : {&steps.back().chart1, &steps.back().chart2})
        for (auto& component : *chart)
          component[i] = i % 3 == 0   ? std::numeric_limits<double>::quiet_NaN()
                         : i % 7 == 0 ? component[(i * 31) % moving.pairs.size()]
                                      : component[i];
    const ContactColumns all = stepped(moving.pairs, set, steps).contacts;
    for (std::size_t i = 0; i < moving.pairs.size(); ++i) {
      std::vector<ContactColumns> own;
      for (const ContactColumns& step : steps) own.push_back(charts_of(step, i));
      const ContactColumns alone = stepped({moving.pairs[i]}, set, own).contacts;
      ASSERT_EQ(all.status[i], alone.status[0]) << i;
      if (all.status[i] == Status::converged) {
        ASSERT_EQ(all.overlap[i], alone.overlap[0]) << i << ' ' << name(set);
      }
      ASSERT_EQ(all.evaluations[i], alone.evaluations[0]) << i << ' ' << name(set);
    }
  }
}

/// Bodies near touch, so that both answers occur and some are close.
TEST(WarmBatch, AYesOrNoIsThatOfAuto) {
  const Want yes_or_no{.overlap = false, .normal = false, .points = false};
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric", "hard"}) {
    Moving moving(family, 130);
    for (Pair& pair : moving.pairs) {
      const Contact<double> at = find_method("auto")->solve(pair, {}, nullptr);
      if (std::isfinite(at.overlap)) pair.body2.position += (at.overlap + (at.evaluations % 3 - 1) * 1e-3) * at.normal;
    }
    const PairColumns columns(moving.pairs);
    for (const InstructionSet set : available_instruction_sets()) {
      ContactColumns out(moving.pairs.size());
      const ContactArrays all = out.arrays();
      const ContactArrays verdicts{.status = all.status,
                                   .verdict = all.verdict,
                                   .evaluations = all.evaluations,
                                   .chart1 = all.chart1,
                                   .chart2 = all.chart2};
      EXPECT_EQ(solve_batch(columns.arrays(), {}, verdicts, set).error, BatchError::none);
      for (std::size_t i = 0; i < moving.pairs.size(); ++i) {
        const Contact<double> alone = find_method("auto")->solve(moving.pairs[i], yes_or_no, nullptr);
        EXPECT_EQ(out.status[i], alone.status) << family << ' ' << i << ' ' << name(set);
        EXPECT_EQ(out.verdict[i], alone.verdict) << family << ' ' << i << ' ' << name(set);
      }
    }
  }
}

TEST(WarmBatch, ChartsOfAnotherLengthAreAnError) {
  Moving moving("spheroid", 5);
  const PairColumns columns(moving.pairs);
  ContactColumns out(5), last(5);
  PairArrays arrays = columns.arrays();
  arrays.last = last.charts();
  arrays.last.chart2[1] = arrays.last.chart2[1].first(4);
  EXPECT_EQ(solve_batch(arrays, {}, out.arrays()).error, BatchError::input_lengths);
  arrays.last = last.charts();
  arrays.before_last.chart1 = last.charts().chart1;
  EXPECT_EQ(solve_batch(arrays, {}, out.arrays()).error, BatchError::input_lengths);
  arrays.before_last = last.charts();
  const BendColumns bends(4);
  arrays.bend = bends.arrays();
  EXPECT_EQ(solve_batch(arrays, {}, out.arrays()).error, BatchError::input_lengths);
}

}  // namespace
}  // namespace plumb
