// Proof files, format plumb/proof-1: what plumb certify --proof writes and --verify reads. Meaning of the fields: corpus/formats/certificate.md.
#pragma once

#include <string>

#include "corpus/case/case.hpp"
#include "solver/reference/proof/proof.hpp"

namespace plumb {

/// A proof with what it is about: the case's doubles, and the bounds that it is said to prove.
struct StoredProof {
  std::string name;  ///< of the case
  Pair pair;
  Bounds claim;  ///< of the overlap; read back inwards, so that what confirms them confirms the text
  reference::Proof proof;
};

/// One line of JSON; every double reads back to the same bits, and the claim's decimals are rounded outwards.
[[nodiscard]] std::string format_proof(const StoredProof& stored);

/// Throws InputFailure for anything but a proof. Whether it holds is another question.
[[nodiscard]] StoredProof parse_proof(const std::string& text, const std::string& file, int line);

/// Why the proof is none of this pair, or does not hold, or does not reach its claim; empty when it proves its claim.
/// `proved`: the bounds that it does prove.
struct Verification {
  std::string failure;
  Bounds proved;
};
[[nodiscard]] Verification verify_stored(const Pair& pair, const StoredProof& stored);

}  // namespace plumb
