// What a method says whatever it is asked: the word for a solver that lies.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "corpus/json/fields.hpp"
#include "solver/contact.hpp"

namespace plumb {

struct Habits {
  std::array<std::uint64_t, 9>
      verdicts{};  ///< answers given, by the certified verdict and then by the one that it says
  std::uint64_t refusals = 0;
  /// Of the answers given, each in 53 bits: equal where all of them are one and the same.
  std::uint64_t least_digest = std::numeric_limits<std::uint64_t>::max() >> 11, greatest_digest = 0;

  /// What crashed or hung gave no answer, and shows no habit.
  void add(Verdict certified, const Contact<double>& answer);
  void merge(const Habits& other);
  /// "never says overlapping: 0 of 512 overlapping pairs"; nothing below eight pairs.
  [[nodiscard]] std::vector<std::string> in_words() const;
  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  [[nodiscard]] static Habits read(const Field& field);
};

}  // namespace plumb
