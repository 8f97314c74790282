// A stored proof, and the verifier that takes a case and the proof and confirms the bounds without searching.
//
// To be believed: this header with proof.cpp, verify.hpp, meridian.hpp, enclosure.hpp, vector_interval.hpp, interval.hpp and
// cover.hpp, and MPFI. Nothing is taken from the search, from a solution, or on trust from the proof itself.
//
//   Bodies that overlap   the cover: each part of all directions has o > level, or a lower bound of its own, or lies in a
//                         region where o has one minimum at most and the region's solution bounds it from below
//   Of revolution         the meridian: o depends on the angle to one line alone, and is bounded on a half circle of
//                         directions; of two spheres a closed form
//   Bodies apart          o(direction) < 0; no two points of the bodies are nearer than the distance, and a stationary
//                         direction with o < 0 is the only one there is
// Either way o(direction) is the upper bound.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/interval/vector_interval.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference {

/// The vector high + low, exactly: 32 digits in doubles.
struct SplitVector {
  Vec3<double> high = Vec3<double>::Zero();
  Vec3<double> low = Vec3<double>::Zero();

  [[nodiscard]] IVec3<Interval80> enclosed() const {
    return reference::enclosed<Interval80>(high) + reference::enclosed<Interval80>(low);
  }
};

/// What bounds the overlap from below.
enum class ProofKind { cover, meridian, spheres, apart };

struct Proof {
  ProofKind kind = ProofKind::cover;
  Cover cover;  ///< of any kind its frame; bodies apart: there may be one region, and the tree is empty
  Meridian meridian;
  std::vector<SplitVector> solutions;  ///< of each region: a chart point of its face, o being lowest near there
  double level = 0;                    ///< over 2^exponent: what the cover excludes is above it
  SplitVector direction;               ///< F times it is the direction whose o is the upper bound, any length
  Witness apart;                       ///< bodies apart: two points of theirs, their distance being the least
};

/// What a proof proves of a pair, or the first thing in it that does not hold.
struct ProofCheck {
  std::string failure;  ///< in words; empty when the proof holds
  Bounds overlap;       ///< of the lowest overlap of all directions
};

/// Takes any pair and any numbers for a proof; does not throw. Intervals of MPFI throughout.
[[nodiscard]] ProofCheck verify_proof(const Pair& pair, const Proof& proof);

}  // namespace plumb::reference
