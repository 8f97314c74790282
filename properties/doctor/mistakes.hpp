// The usual mistakes of an adapter: each one a row that says what a solver with this mistake alone would answer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb::doctor {

/// What is read off the answers themselves: how many times the true overlap each overlap is, and how long the normals are.
struct Fit {
  double overlap_factor = 1;
  double normal_length = 1;
};

/// An answer, and the size to which its lengths are relative.
struct Told {
  Contact<double> contact;
  double size = 1;
};

struct Mistake {
  std::string_view name;      ///< "normal_reversed"; several rows may share one
  std::string_view sentence;  ///< what is wrong and what to change; {} stands for the figure
  /// The pair that is solved in the place of the one asked; nullopt: there is none, and the row says nothing of it.
  std::optional<Pair> (*misread)(const Pair& asked) = nullptr;
  void (*mistell)(Told& told, const Pair& asked, const Fit& fit) = nullptr;
  double Fit::* figure = nullptr;
};

/// All of them: those of the answer before those of the pair, the simpler before what contains it.
[[nodiscard]] std::span<const Mistake> mistakes();

[[nodiscard]] std::string sentence_of(const Mistake& mistake, const Fit& fit);

}  // namespace plumb::doctor
