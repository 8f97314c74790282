// What is wrong with an answer, and by how much: what a case keeps while it is shrunk.
#pragma once

#include <string>

#include "properties/laws/judged_answer.hpp"

namespace plumb {

/// The size of a defect is, where it is known:
///   misaligned, wrong_branch         degrees from the certified common normal
///   overlap_error                    lengths from the certified overlap
///   false_contact, missed_contact    the certified overlap or distance that was mistaken
///   off_surface, point_error         lengths from the certified points
/// Lengths are of the larger body's size. NaN: not known, or the kind has no size.
struct Defect {
  FindingKind kind = FindingKind::none;
  double size = 0;
};

[[nodiscard]] Defect defect_of(const Pair& pair, const JudgedAnswer& found);

/// Whether one is still the other: of its kind, and its size within a factor. Where the first has no size the kind is all that
/// is asked for.
[[nodiscard]] bool is_same(const Defect& from, const Defect& now);

/// The size in words: "131 degrees"; empty where it says nothing.
[[nodiscard]] std::string size_text(const Defect& defect);

}  // namespace plumb
