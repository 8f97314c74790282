// Pairs of the contact list as the columns that a batch reads and writes.
#pragma once

#include <array>
#include <span>

#include "solver/batch/batch.hpp"
#include "solver/scene/body/world.hpp"

namespace plumb::scene {

class PairChunk {
 public:
  static constexpr std::size_t capacity = 64;

  void clear() { count_ = 0; }
  /// A pair of bodies, no wall, with the charts that its contact has kept.
  void add(const World& world, std::size_t contact);

  /// Whether they overlap. `with_direction`: and along which those do not that are apart.
  void ask(const Want& want, bool with_direction);
  /// Overlap, normal and points.
  void solve(const Want& want);

  /// What the k-th was answered; where it was asked status, verdict, charts, counts and maybe the direction for a normal.
  [[nodiscard]] Contact<double> answer(std::size_t k) const;

 private:
  using Column = std::array<double, capacity>;
  using Vectors = std::array<Column, 3>;
  struct Side {
    Vectors semi_axes, position, last, before_last;
    std::array<std::array<float, capacity>, 3> bend;
    Column n1, n2;
    std::array<Column, 4> quaternion;
  };

  static void set(const World& world, std::size_t body, const Vec3<double>& position, std::size_t k, Side& to);
  [[nodiscard]] BodyArrays arrays(const Side& of) const;
  [[nodiscard]] PairArrays pairs() const;
  [[nodiscard]] ContactArrays verdicts();
  void run(const Want& want, const ContactArrays& to);

  std::size_t count_ = 0;
  Side side1_, side2_;
  std::array<Status, capacity> status_;
  std::array<Verdict, capacity> verdict_;
  Column overlap_;
  Vectors normal_, point1_, point2_, contact_point_, chart1_, chart2_;
  std::array<int, capacity> iterations_, evaluations_;
  bool is_solved_ = false, has_normal_ = false;
};

}  // namespace plumb::scene
