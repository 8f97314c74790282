// Pairs with an answer, and a folder of its own for each test's recorder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "corpus/case/shape_class.hpp"
#include "properties/doors/recording.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/method/methods.hpp"

namespace plumb {

struct Recorded {
  plumb_recorder_body body1, body2;
  plumb_recorder_answer answer;

  int give_to(plumb_recorder* recorder) const { return plumb_record(recorder, &body1, &body2, &answer); }
};

inline Recorded recorded(const Pair& pair, const Contact<double>& contact) {
  return {recorder_body(pair.body1), recorder_body(pair.body2), recorder_answer(contact)};
}

inline Contact<double> answer_of(std::string_view method, const Pair& pair) {
  return find_method(method)->solve(pair, {}, nullptr);
}

/// An ellipsoid and a superellipsoid that penetrate each other by a tenth.
inline Pair deep_pair() {
  Pair pair;
  pair.body1.shape = {{1, 0.8, 0.6}, 2, 2};
  pair.body2.shape = {{0.9, 0.7, 1.1}, 4, 3};
  pair.body2.position = {1.3, 0.5, 0.4};
  pair.body2.quaternion = {0.9, 0.1, -0.3, 0.2};
  return pair;
}

class Folder : public Commands {
 protected:
  void TearDown() override {
    plumb_recorder_close(recorder_);
    Commands::TearDown();
  }
  plumb_recorder* open(const plumb_recorder_options& options = plumb_recorder_defaults()) {
    plumb_recorder_close(recorder_);
    return recorder_ = plumb_recorder_open(folder().c_str(), &options);
  }
  [[nodiscard]] std::string folder() const { return (path_ / "kept").string(); }
  /// Sorted.
  [[nodiscard]] std::vector<std::string> kept() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder()))
      if (entry.path().extension() == ".json") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  [[nodiscard]] plumb_recorder_counts counts() const { return plumb_recorder_counted(recorder_); }

  plumb_recorder* recorder_ = nullptr;
};

}  // namespace plumb
