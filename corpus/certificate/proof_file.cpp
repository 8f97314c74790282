#include "corpus/certificate/proof_file.hpp"

#include <cmath>
#include <limits>
#include <string_view>

#include "corpus/json/decimal.hpp"
#include "corpus/json/fields.hpp"

namespace plumb {
namespace {

using namespace reference;

constexpr const char* proof_format = "plumb/proof-1";
constexpr int claimed_digits = 50;
constexpr std::string_view leaf_letters = "sxobc";  // in the order of Leaf

Json split_json(const SplitVector& v) {
  return {{"high", vector_json(v.high)}, {"low", vector_json(v.low)}};
}

Json region_json(const Cell& region, const SplitVector& solution) {
  return {{"axis", region.axis}, {"sign", region.sign}, {"u", region.u},
          {"v", region.v},       {"half", region.half}, {"solution", split_json(solution)}};
}

Json witness_json(const Witness& witness) {
  return {vector_json(witness.point1), vector_json(witness.point2)};
}

Json meridian_json(const Meridian& meridian) {
  Json out{{"places", meridian.places}, {"witnesses", Json::array()}};
  for (const Witness& witness : meridian.witnesses) out["witnesses"].push_back(witness_json(witness));
  out["valleys"] = Json::array();
  for (const auto& [first, last, high, low] : meridian.valleys)
    out["valleys"].push_back({{"first", first}, {"last", last}, {"high", high}, {"low", low}});
  return out;
}

std::string tree_text(const std::vector<Leaf>& tree) {
  std::string out;
  for (const Leaf leaf : tree) out += leaf_letters[static_cast<std::size_t>(leaf)];
  return out;
}

void put_cover(Json& out, const Proof& proof) {
  out["level"] = proof.level;
  out["tree"] = tree_text(proof.cover.tree);
  out["witnesses"] = Json::array();
  for (const Witness& witness : proof.cover.witnesses) out["witnesses"].push_back(witness_json(witness));
  out["regions_of"] = proof.cover.regions_of;
}

void put_proof(Json& out, const Proof& proof) {
  out["frame"] = Json::array();
  for (int i = 0; i < 3; ++i) out["frame"].push_back(vector_json(proof.cover.frame.row(i)));
  out["direction"] = split_json(proof.direction);
  out["regions"] = Json::array();
  for (std::size_t i = 0; i < proof.cover.regions.size(); ++i)
    out["regions"].push_back(region_json(proof.cover.regions[i], proof.solutions[i]));
  switch (proof.kind) {
    case ProofKind::cover: return put_cover(out, proof);
    case ProofKind::meridian: out["meridian"] = meridian_json(proof.meridian); return;
    case ProofKind::spheres: out["spheres"] = true; return;
    case ProofKind::apart: out["apart"] = witness_json(proof.apart); return;
  }
}

SplitVector read_split(const Field& field) {
  field.require_object({"high", "low"});
  return {field.member("high").vector(), field.member("low").vector()};
}

Witness read_witness(const Field& field) {
  return {field.element(0, 2, "points").vector(), field.element(1, 2, "points").vector()};
}

void read_region(const Field& field, Proof& out) {
  field.require_object({"axis", "sign", "u", "v", "half", "solution"});
  Cell region{field.member("axis").whole_number(0, 2), field.member("sign").number(), field.member("u").number(),
              field.member("v").number(), field.member("half").number()};
  if (std::abs(region.sign) != 1) field.member("sign").fail("must be -1 or 1");
  if (region.half < 0) field.member("half").fail("must not be negative");
  out.cover.regions.push_back(region);
  out.solutions.push_back(read_split(field.member("solution")));
}

std::vector<Leaf> read_tree(const Field& field) {
  std::vector<Leaf> out;
  for (const char letter : field.text()) {
    const std::size_t leaf = leaf_letters.find(letter);
    if (leaf == std::string_view::npos) field.fail("must hold no letters but s, x, o, b and c");
    out.push_back(static_cast<Leaf>(leaf));
  }
  return out;
}

void read_cover(const Field& root, Proof& out) {
  out.level = root.member("level").number();
  out.cover.tree = read_tree(root.member("tree"));
  for (const Field& witness : root.member("witnesses").elements()) out.cover.witnesses.push_back(read_witness(witness));
  for (const Field& index : root.member("regions_of").elements())
    out.cover.regions_of.push_back(index.whole_number(0, std::numeric_limits<int>::max()));
}

Valley read_valley(const Field& field) {
  field.require_object({"first", "last", "high", "low"});
  return {field.member("first").number(), field.member("last").number(), field.member("high").number(),
          field.member("low").number()};
}

Meridian read_meridian(const Field& field) {
  field.require_object({"places", "witnesses", "valleys"});
  Meridian out;
  for (const Field& place : field.member("places").elements()) out.places.push_back(place.number());
  for (const Field& witness : field.member("witnesses").elements()) out.witnesses.push_back(read_witness(witness));
  for (const Field& valley : field.member("valleys").elements()) out.valleys.push_back(read_valley(valley));
  return out;
}

/// The kind by the field that only it has.
ProofKind read_kind(const Field& root) {
  if (root.has("apart")) return ProofKind::apart;
  if (root.has("meridian")) return ProofKind::meridian;
  return root.has("spheres") ? ProofKind::spheres : ProofKind::cover;
}

void read_lower_bound(const Field& root, Proof& out) {
  switch (out.kind) {
    case ProofKind::cover: return read_cover(root, out);
    case ProofKind::meridian: out.meridian = read_meridian(root.member("meridian")); return;
    case ProofKind::spheres: return;
    case ProofKind::apart: out.apart = read_witness(root.member("apart")); return;
  }
}

Proof read_proof(const Field& root) {
  Proof out;
  const Field frame = root.member("frame");
  for (int i = 0; i < 3; ++i) out.cover.frame.row(i) = frame.element(static_cast<std::size_t>(i), 3, "rows").vector();
  out.direction = read_split(root.member("direction"));
  for (const Field& region : root.member("regions").elements()) read_region(region, out);
  out.kind = read_kind(root);
  read_lower_bound(root, out);
  return out;
}

Real50 read_bound(const Field& field, Rounding inwards) {
  Real50 out = read_decimal(field.text(), inwards);
  if (isnan(out)) field.fail("must be a decimal number");
  return out;
}

Bounds read_claimed(const Field& claim) {
  claim.require_object({"overlap"});
  const Field overlap = claim.member("overlap");
  overlap.require_object({"lower", "upper"});
  return {read_bound(overlap.member("lower"), Rounding::up), read_bound(overlap.member("upper"), Rounding::down)};
}

StoredProof read_stored(const Field& root) {
  const auto require = [&](auto... own) {
    root.require_object({"format", "name", "bodies", "claim", "frame", "direction", "regions", own...});
  };
  switch (read_kind(root)) {
    case ProofKind::cover: require("level", "tree", "witnesses", "regions_of"); break;
    case ProofKind::meridian: require("meridian"); break;
    case ProofKind::spheres: require("spheres"); break;
    case ProofKind::apart: require("apart"); break;
  }
  root.member("format").require_text(proof_format);
  const auto name = root.find("name");
  return {name ? name->text() : "", read_pair(root), read_claimed(root.member("claim")), read_proof(root)};
}

/// The two bodies' first difference; the text of a double is its bits.
std::string find_other_body(const Pair& pair, const Pair& proved) {
  const Json ours = bodies_json(pair), theirs = bodies_json(proved);
  for (const std::size_t i : {0U, 1U})
    if (write_json(ours[i]) != write_json(theirs[i])) return "it is about another bodies[" + std::to_string(i) + "]";
  return {};
}

}  // namespace

std::string format_proof(const StoredProof& stored) {
  Json out;
  out["format"] = proof_format;
  out["name"] = stored.name;
  out["bodies"] = bodies_json(stored.pair);
  out["claim"]["overlap"] = {{"lower", decimal(stored.claim.lower, claimed_digits, Rounding::down)},
                             {"upper", decimal(stored.claim.upper, claimed_digits, Rounding::up)}};
  put_proof(out, stored.proof);
  return write_json(out);
}

StoredProof parse_proof(const std::string& text, const std::string& file, int line) {
  try {
    const Json tree = read_json(text);
    return read_stored(Field(tree));
  } catch (const FieldError& error) {
    throw InputFailure(file, line, error.field, error.what());
  }
}

Verification verify_stored(const Pair& pair, const StoredProof& stored) {
  if (std::string other = find_other_body(pair, stored.pair); !other.empty()) return {std::move(other), {}};
  const ProofCheck check = verify_proof(pair, stored.proof);
  Verification out{check.failure, check.overlap};
  if (!out.failure.empty()) return out;
  const auto beyond = [](const char* end, const Real50& proved, Rounding rounding) {
    return std::string("it claims more than it proves: overlap.") + end + " is " +
           decimal(proved, claimed_digits, rounding);
  };
  if (stored.claim.lower > check.overlap.lower) out.failure = beyond("lower", check.overlap.lower, Rounding::down);
  if (stored.claim.upper < check.overlap.upper) out.failure = beyond("upper", check.overlap.upper, Rounding::up);
  return out;
}

}  // namespace plumb
