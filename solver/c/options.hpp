// plumb_options: how a pair is solved, and what of it is legal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "solver/contact.hpp"
#include "solver/plumb.h"

namespace plumb {

/// Options as this library knows them: a caller of an older header has fewer of them, and the rest are the defaults.
[[nodiscard]] inline plumb_options options_of(const plumb_options* given) {
  plumb_options out = PLUMB_OPTIONS;
  if (given == nullptr) return out;
  std::memcpy(&out, given, std::min(given->size, sizeof out));
  out.size = given->size;
  return out;
}

inline constexpr unsigned all_wants =
    PLUMB_WANT_CONTACT | PLUMB_WANT_CURVATURE | PLUMB_WANT_DERIVATIVES | PLUMB_WANT_PATCH;

/// A size that ends within a field is no header's: of a pointer a part would be left.
[[nodiscard]] inline bool is_of_a_header(std::size_t size) {
  constexpr std::array ends{offsetof(plumb_options, method),          offsetof(plumb_options, want),
                            offsetof(plumb_options, iteration_limit), offsetof(plumb_options, tolerance),
                            offsetof(plumb_options, motion),          offsetof(plumb_options, patch_tolerance),
                            offsetof(plumb_options, witnesses)};
  return size >= sizeof(plumb_options) || std::find(ends.begin(), ends.end(), size) != ends.end();
}

[[nodiscard]] inline bool are_legal(const plumb_options& options) {
  return is_of_a_header(options.size) && (options.want & ~all_wants) == 0 && options.iteration_limit > 0 &&
         options.tolerance >= 0 && std::isfinite(options.tolerance) && options.patch_tolerance > 0 &&
         std::isfinite(options.patch_tolerance) && Vec3<double>::Map(options.motion).allFinite();
}

/// For what no other method solves.
[[nodiscard]] inline bool is_auto(const plumb_options& options) {
  return options.method == nullptr || std::string_view(options.method) == "auto";
}

[[nodiscard]] inline Want want_of(const plumb_options& options) {
  const auto is_wanted = [&](unsigned bit) { return (options.want & bit) != 0; };
  return {.overlap = is_wanted(PLUMB_WANT_OVERLAP),
          .normal = is_wanted(PLUMB_WANT_NORMAL),
          .points = is_wanted(PLUMB_WANT_POINTS),
          .curvature = is_wanted(PLUMB_WANT_CURVATURE),
          .derivatives = is_wanted(PLUMB_WANT_DERIVATIVES),
          .patch = is_wanted(PLUMB_WANT_PATCH),
          .patch_tolerance = options.patch_tolerance,
          .iteration_limit = options.iteration_limit,
          .tolerance = options.tolerance};
}

}  // namespace plumb
