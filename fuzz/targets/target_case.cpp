// Bytes as the text of a case file: the parser refuses with InputFailure or reads; what it reads is legal and survives
// format and parse bit for bit.
#include <fmt/format.h>

#include <array>
#include <bit>

#include "corpus/case/case.hpp"
#include "fuzz/targets/target.hpp"

namespace plumb {
namespace {

using BodyBits = std::array<std::uint64_t, 12>;

BodyBits bits_of(const Body& body) {
  const auto& [shape, p, q] = body;
  const std::array<double, 12> numbers{shape.semi_axes[0],
                                       shape.semi_axes[1],
                                       shape.semi_axes[2],
                                       shape.n1,
                                       shape.n2,
                                       p[0],
                                       p[1],
                                       p[2],
                                       q[0],
                                       q[1],
                                       q[2],
                                       q[3]};
  BodyBits bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = std::bit_cast<std::uint64_t>(numbers[i]);
  return bits;
}

bool same_bits(const Pair& a, const Pair& b) {
  return bits_of(a.body1) == bits_of(b.body1) && bits_of(a.body2) == bits_of(b.body2);
}

/// A polyhedron's points become its corners: it is what is written that stays.
Outcome examine_case(const Case& c) {
  if (!c.convex && !is_valid(c.pair)) return {true, "the reader accepted a pair that is not legal input"};
  try {
    const std::string written = format_case(c);
    const Case again = parse_case(written, "formatted", 0, CaseShapes::every);
    if (!same_bits(c.pair, again.pair)) return {true, "format and parse changed the pair"};
    if (c.convex && format_case(again) != written) return {true, "format and parse changed the shapes"};
  } catch (const InputFailure& e) {
    return {true, fmt::format("the writer wrote what the reader refuses: {}", e.what())};
  }
  return {false, "read, and the same after format and parse"};
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  try {
    return examine_case(parse_case(std::string(bytes.begin(), bytes.end()), "input", 0, CaseShapes::every));
  } catch (const InputFailure& e) {
    return {false, fmt::format("refused: {}", e.what())};
  } catch (const std::exception& e) {
    return {true, fmt::format("the reader threw what it must not: {}", e.what())};
  }
}

}  // namespace plumb
