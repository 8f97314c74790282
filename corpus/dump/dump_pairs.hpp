// The pairs of a dump's frame that touch, over periodic boundaries as well.
#pragma once

#include <array>
#include <functional>

#include "corpus/dump/dump_frame.hpp"

namespace plumb {

struct DumpPair {
  std::size_t first, second;   ///< places in the frame's particles; the same where a particle touches its own image
  std::array<int, 3> image{};  ///< body 2 is shifted by so many edges of the box
  Pair pair;
};

/// Hands out every pair that overlaps by `auto`'s verdict, and with gap > 0 those less than gap sizes of the larger body apart,
/// by rising ids and images. A pair that `auto` cannot settle is handed out: it is left to who judges. Stops at Ctrl-C. Throws
/// std::invalid_argument where the box is so small that there are more than 2e7 images to look at.
void each_touching_pair(const DumpFrame& frame, double gap, const std::function<void(const DumpPair&)>& take);

}  // namespace plumb
