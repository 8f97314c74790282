// The laws on answers along a motion: what two consecutive steps say of each other, and a warm start of a cold one.
//
// A pose P has the overlap function o_P(n) = h1(R1'n) + h2(-R2'n) - n.(c2 - c1) of unit n; its lowest value o_P is the overlap
// and the direction n_P where it is taken the normal. From pose P to Q let
//   D = |(c2 - c1)_Q - (c2 - c1)_P| + |R1_Q - R1_P| + |R2_Q - R2_P|,
// where |R_Q - R_P| stands for the largest displacement of a point of the body's box by the turn alone; a linear map's largest
// value on a box is at a corner. A support function is the largest n.x over the body, so no h moves by more than that:
//   (1)  |o_Q(n) - o_P(n)| <= D                          for every n
//   (2)  |o_Q - o_P| <= D                                as o_Q <= o_Q(n_P) <= o_P(n_P) + D
//   (3)  o_P(n_Q) <= o_Q(n_Q) + D = o_Q + D <= o_P + 2 D
// (2) is `lipschitz`, (3) `normal_follows`: Q's normal cannot be a bad direction of P. Neither needs a reference. While |o_P|
// exceeds D, (2) fixes Q's sign as well: `no_flicker`.
//
// Rounding. An answer counts as exact for an input that differs by a few epsilon, whose overlap function differs by at most
// delta = few (condition of the overlap) (size + |o|). So an answer's overlap is off by delta, and its normal has
// o(n) <= o + 2 delta: (2) is held to delta_P + delta_Q, (3) to delta_P + 2 delta_Q. The doubles of n add few |grad o|, and
// grad o is the vector between two points of the bodies: few (r1 + r2 + |c2 - c1|).
//
// First order, `normal_rate`. Condition::normal adds up the responses of the normal (reference/sensitivity.hpp): with T that to a
// shift of one body against the other, W1 and W2 those to turns (rad), kappa >= 2 L T + 2 W1 + 2 W2. Along a straight motion
// from P to Q, with m = max(shift / L, turn of body 1, turn of body 2), the normal turns by at most
//   integral of (T shift + W1 turn1 + W2 turn2) <= m / 2 times the largest kappa on the way
// as long as the minimum is one branch. On the way kappa is not known. Where kappa m is below 0.1 at both ends the normal stays
// within a tenth of a radian, and it is taken to at most double: then
//   (4)  angle(n_P, n_Q) <= m max(kappa_P, kappa_Q) + few (1 + kappa_P) + few (1 + kappa_Q).
// That is no theorem: curvature may rise and fall within a step (a sharp edge), and minima switch. An answer breaks the law
// only where it turns by more than (4) and by more than the certified normals do, the widest of those that tie. Where a normal
// is not determined, or not all ties are known, the law says nothing.
//
// `warm_is_cold`: a solve that starts from the step before breaks no law of laws() that a cold one keeps, and has the same overlap
// and the same verdict, to rounding. Which of several tied minima it finds is open.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "properties/laws/laws.hpp"

namespace plumb {

struct PathStep {
  Pair pair;
  Contact<double> cold;
  Contact<double> warm;              ///< from the warm answer of the step before; the first step's is the cold one
  Finding broken_cold, broken_warm;  ///< of laws() that judge one answer by itself
  const Reference* reference = nullptr;
  const Solution* own = nullptr;  ///< to the method's own problem
};

struct PathEvidence {
  Problem problem = Problem::common_normal;
  std::vector<PathStep> steps;
};

/// Two consecutive steps.
struct PathLink {
  Problem problem;
  const PathStep &from, &to;
};

/// D: no point of one body moves by more against the other, but for a turn that both share. A length.
[[nodiscard]] double displacement(const Pair& from, const Pair& to);

/// m: the larger of shift / size and the turns of both bodies (rad).
[[nodiscard]] double relative_motion(const Pair& from, const Pair& to);

struct PathLaw {
  std::string_view name;
  std::string_view statement;
  Finding (*check)(const PathLink&);
};
[[nodiscard]] std::span<const PathLaw> path_laws();

struct PathFinding {
  std::size_t step = 0;  ///< of the link, the later
  Finding finding;
};

/// Every law that is broken, at every step: first of laws(), by the cold answer, then of paths.
[[nodiscard]] std::vector<PathFinding> judge_path(const PathEvidence& evidence);

/// Anything that answers, from an earlier contact or from none.
using WarmSolve = std::function<Contact<double>(const Pair&, const Contact<double>* last)>;

/// Gathers the evidence. The references are computed once, and shared by all methods that follow the same path.
class PathJudge {
 public:
  explicit PathJudge(const std::vector<Pair>& pairs, const ReferenceSource& source = {});
  /// The references stay with the judge.
  [[nodiscard]] PathEvidence follow(Problem problem, const WarmSolve& solve);

 private:
  std::vector<Pair> pairs_;
  std::deque<Judge> judges_;
};

}  // namespace plumb
