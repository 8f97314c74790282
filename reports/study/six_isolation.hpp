// One solution of one of the 8 systems: the proof that it exists, and a square of directions in which it is the only one.
#pragma once

#include <optional>

#include "reports/study/six_roots.hpp"
#include "reports/study/six_system.hpp"
#include "solver/reference/interval/digits.hpp"

namespace plumb::reports {

/// What the search looks with, and what a solution's digits are proved with.
using Look = reference::DoubleInterval;
using Fine = reference::Interval80;

/// A square in which a system has one zero at most.
struct Region {
  SixSystem system;
  reference::Cell cell;
};
[[nodiscard]] bool contains(const Region& region, const SixSystem& system, const reference::Cell& cell);

/// A proved solution.
struct Isolated {
  Region region;
  IVec3<Fine> v;  ///< holds it; on the face of the region
  SixBranch branch;
  IVec3<Fine> normal1, point1, point2;  ///< hold it; pair frame
};
/// Whether they are one solution of one system, seen from two places.
[[nodiscard]] bool is_same(const Isolated& known, const Isolated& found);
/// Whether no component says that they are two.
[[nodiscard]] bool cannot_be_told_apart(const Isolated& a, const Isolated& b);

class SixIsolator {
 public:
  explicit SixIsolator(const Pair& pair);

  [[nodiscard]] const SixPair<Look>& look() const { return look_; }

  /// The proof for a zero to the digits of double; empty where there is none.
  [[nodiscard]] std::optional<Isolated> isolate(const SixSystem& system, const Face& face,
                                                const Vec3<double>& near) const;
  /// In the world's frame; a solution that several branches share is given by all of them.
  [[nodiscard]] SixRoot report(const std::vector<Isolated>& shared) const;

 private:
  [[nodiscard]] Vec3<Real50> refined(const SixSystem& system, const Face& face, const Vec3<double>& near) const;
  [[nodiscard]] std::optional<IVec3<Fine>> contract(const SixSystem& system, const Face& face,
                                                    const Vec3<Real50>& at) const;
  [[nodiscard]] std::optional<Region> region_about(const SixSystem& system, const Face& face,
                                                   const IVec3<Fine>& v) const;
  [[nodiscard]] bool set_solution(Isolated& out) const;

  const Pair pair_;
  const reference::EnclosedPair<Fine> fine_enclosure_;
  const SixPair<Fine> fine_;
  const SixPair<Look> look_;
};

}  // namespace plumb::reports
