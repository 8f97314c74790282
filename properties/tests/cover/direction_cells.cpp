// The queue of the search over directions holds no more than may wait: it must lose nothing and keep the order.
#include "solver/method/auto/cover/direction_cells.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace plumb {
namespace {

using Cell = DirectionCell<double>;

void expect_same(const Cell& found, const Cell& expected) {
  EXPECT_EQ(found.u, expected.u);
  EXPECT_EQ(found.v, expected.v);
  EXPECT_EQ(found.face, expected.face);
  EXPECT_EQ(found.depth, expected.depth);
}

/// The number of the push, as a witness.
Vector3<double> numbered(int push) {
  return {1.0 * push, -1.0 * push, 0.5};
}

// Each cell that is taken out is divided, which no search can exceed, until all are pushed.
TEST(DirectionCells, TheQueueHoldsWhatTheWorstSearchDivides) {
  constexpr int most = 1650;
  struct Waiting {
    Cell cell;
    int above;
  };
  DirectionQueue<double, most> queue;
  std::deque<Waiting> plain;
  int pushed = 0;
  const auto push = [&](const Cell& divided) {
    for (int part = 0; part < Cell::parts; ++part) plain.push_back({divided.part(part), pushed});
    queue.push(divided, numbered(pushed++));
  };
  for (int face = 0; face < Cell::faces; ++face) push({0, 0, face, 0});
  for (; !plain.empty(); plain.pop_front()) {
    ASSERT_FALSE(queue.is_empty());
    const Cell cell = queue.next();
    expect_same(cell, plain.front().cell);
    EXPECT_EQ(queue.witness().x, plain.front().above);
    EXPECT_EQ(queue.witness().y, -plain.front().above);
    if (pushed < most) push(cell);
  }
  EXPECT_TRUE(queue.is_empty());
}

TEST(DirectionCells, TheDeepestAreKeptAsTheyAre) {
  DirectionQueue<double, 8> queue;
  for (const std::int32_t side : {-1, 1}) {
    const std::int32_t rim = side * ((1 << (Cell::deepest - 1)) - 1);
    const Cell divided{rim, -rim, Cell::faces - 1, Cell::deepest - 1};
    queue.push(divided, numbered(0));
    for (int part = 0; part < Cell::parts; ++part) expect_same(queue.next(), divided.part(part));
  }
}

}  // namespace
}  // namespace plumb
