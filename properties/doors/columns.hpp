// Pairs and answers as the columns that a batch reads and writes (solver/batch/batch.hpp).
#pragma once

#include <span>
#include <vector>

#include "solver/batch/batch.hpp"

namespace plumb {

class PairColumns {
 public:
  explicit PairColumns(std::span<const Pair> pairs);
  [[nodiscard]] PairArrays arrays() const;

 private:
  using Columns = std::array<std::vector<double>, 12>;  // semi-axes, exponents, position, quaternion

  static void append(const Body& body, Columns& to);
  [[nodiscard]] static BodyArrays arrays(const Columns& of);

  Columns body1_, body2_;
};

struct ContactColumns {
  explicit ContactColumns(std::size_t size);
  [[nodiscard]] ContactArrays arrays();
  /// Where a step that follows starts.
  [[nodiscard]] ChartArrays charts() const;
  /// Those of one pair; the fields that a batch does not have are as in Contact().
  [[nodiscard]] Contact<double> at(std::size_t i) const;

  std::vector<Status> status;
  std::vector<Verdict> verdict;
  std::vector<double> overlap;
  std::array<std::vector<double>, 3> normal, point1, point2, contact_point, chart1, chart2;
  std::vector<int> iterations, evaluations;
};

/// The bends of each pair's charts, NaN until they are set.
struct BendColumns {
  explicit BendColumns(std::size_t size);
  void set(std::size_t i, const Vec3<float>& of1, const Vec3<float>& of2);
  [[nodiscard]] BendArrays arrays() const;

  std::array<std::vector<float>, 3> bend1, bend2;
};

/// Those that this machine runs, the narrowest first.
[[nodiscard]] std::vector<InstructionSet> available_instruction_sets();

}  // namespace plumb
