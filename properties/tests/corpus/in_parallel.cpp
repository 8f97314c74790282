// Work on several threads: all of it, in any number of threads, and what it throws.
#include "corpus/command/in_parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plumb {
namespace {

TEST(InParallel, AllIsDoneOnce) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    std::vector<int> done(1000);
    in_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 1000) << threads;
    EXPECT_EQ(*std::max_element(done.begin(), done.end()), 1) << threads;
  }
}

TEST(InParallel, WhatWorkThrowsArrives) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<int> begun{0};
    const auto work = [&](std::size_t i) {
      ++begun;
      if (i == 5) throw std::runtime_error("the sixth");
    };
    EXPECT_THROW(in_parallel(1000, threads, work), std::runtime_error);
    EXPECT_GE(begun, 6);
    EXPECT_LE(begun, threads == 1 ? 6 : 1000) << "nothing more is begun";
  }
}

}  // namespace
}  // namespace plumb
