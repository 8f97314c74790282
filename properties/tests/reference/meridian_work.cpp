// The verifier of meridians: what a long proof takes, counted (meter.hpp), and that its sweep over the valleys leaves none out.
#include <gtest/gtest.h>

#include <stdexcept>

#include "properties/generators/draft.hpp"
#include "solver/reference/meter.hpp"
#include "solver/reference/proof/meridian.hpp"
#include "solver/reference/proof/proof.hpp"
#include "solver/reference/search/make_proof.hpp"

namespace plumb::reference {
namespace {

/// Spheroids whose axes are one line.
Pair spheroids_in_line() {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape = pair.body1.shape;
  pair.body2.position << 0, 0, 1;
  return pair;
}

Proof proof_of(const Pair& pair) {
  const auto out = make_proof(pair, find_reference(pair, Effort::bounds));
  if (!out || out->kind != ProofKind::meridian || out->meridian.valleys.empty())
    throw std::logic_error("spheroids in line have a proof by valleys of a meridian");
  return *out;
}

/// Every arc in as many parts, and over each of them a valley.
Meridian divided(const Meridian& from, int parts) {
  Meridian out{{from.places.front()}, {}, {}};
  for (std::size_t i = 0; i < from.witnesses.size(); ++i)
    for (int part = 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      out.places.push_back(from.places[i] + (from.places[i + 1] - from.places[i]) * share);
      out.witnesses.push_back(from.witnesses[i]);
      out.valleys.push_back(from.valleys[i % from.valleys.size()]);
    }
  return out;
}

std::int64_t work_of(const Pair& pair, const Proof& proof) {
  const std::int64_t before = work_counted;
  EXPECT_EQ(verify_proof(pair, proof).failure, "");
  return work_counted - before;
}

TEST(MeridianWork, GrowsNoFasterThanTheProof) {
  const Pair pair = spheroids_in_line();
  const Proof proof = proof_of(pair);
  Proof longer = proof, longest = proof;
  longer.meridian = divided(proof.meridian, 16);
  longest.meridian = divided(proof.meridian, 64);
  EXPECT_LT(work_of(pair, longest), 5 * work_of(pair, longer));
}

/// Of every arc the best of its points and of all valleys that hold it, one by one.
double least_one_by_one(const FramedPair<Interval80>& framed, const Meridian& meridian) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < meridian.witnesses.size(); ++i) {
    const Arc arc{meridian.places[i], meridian.places[i + 1]};
    const auto apart = points_apart<Interval80>(framed.pair, meridian.witnesses[i]);
    if (!apart) throw std::logic_error("a witness of a proof that holds lies in its body");
    double bound = least_on<Interval80>(framed, arc, *apart);
    for (const Valley& valley : meridian.valleys) {
      const auto least = least_in<Interval80>(framed, valley);
      if (valley.first <= arc.first && arc.last <= valley.last && least) bound = std::max(bound, low(*least));
    }
    out = std::min(out, bound);
  }
  return out;
}

/// Valleys that begin and end anywhere, some of them none.
TEST(MeridianWork, EveryValleyThatHoldsAnArcBoundsIt) {
  const Pair pair = spheroids_in_line();
  const Proof proof = proof_of(pair);
  const FramedPair<Interval80> framed(enclose<Interval80>(pair), proof.cover.frame);
  Stream stream("valleys", 1, 0);
  for (int i = 0; i < 30; ++i) {
    Meridian meridian = divided(proof.meridian, 2);
    const Valley whole = proof.meridian.valleys.front();
    const double width = whole.last - whole.first;
    meridian.valleys.clear();
    for (int k = 0; k < 6; ++k) {
      const double middle = whole.first + width * stream.uniform(0, 1);
      meridian.valleys.push_back({middle - width * stream.uniform(0, 0.7), middle + width * stream.uniform(0, 0.7),
                                  k % 3 == 0 ? whole.high : middle, k % 3 == 0 ? whole.low : 0});
    }
    const auto found = verify_meridian<Interval80>(pair, framed, meridian);
    ASSERT_TRUE(found.well_formed);
    const double expected = least_one_by_one(framed, meridian);
    EXPECT_NEAR(low(found.least), expected, 1e-30) << i;
  }
}

}  // namespace
}  // namespace plumb::reference
