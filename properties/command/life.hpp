// The life of a kept case. The folder that it lies in says what is asked of it, and plumb promote moves it to the next.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

struct Replayed;

/// open: known failures, expected to fail; incubating: fails no more, watched for a while; regressions: mended, must pass.
enum class Life { open, incubating, regressions };
inline constexpr std::string_view life_folders[] = {"open", "incubating", "regressions"};

/// By the folder that the file lies in; nullopt in any other than the three.
[[nodiscard]] std::optional<Life> life_of(const std::string& file);

/// A finding of a method of plumb's own (no published baseline), or nothing to judge it by: a gap of the reference.
[[nodiscard]] bool is_open(const Replayed& replayed);

/// What the folder asks and today's answer does not give, in words; empty: nothing.
[[nodiscard]] std::string out_of_place(Life life, const Replayed& replayed);

}  // namespace plumb
