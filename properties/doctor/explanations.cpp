#include "properties/doctor/explanations.hpp"

#include <algorithm>
#include <optional>

namespace plumb::doctor {
namespace {

/// What a mistake predicts, question by question; nothing where it says nothing.
using Prediction = std::vector<std::optional<Told>>;

std::optional<Told> first_told(const Mistake& mistake, const Question& question, Problem problem) {
  const double size = size_of(question.pair);
  if (mistake.misread == nullptr) return Told{question.truth, size};
  const std::optional<Pair> pair = mistake.misread(question.pair);
  if (!pair) return std::nullopt;
  const Contact<double> answer = own_answer(*pair, problem);
  if (answer.status != Status::converged) return std::nullopt;
  return Told{answer, size};
}

void tell(Prediction& prediction, const Mistake& mistake, const Examined& examined) {
  if (mistake.mistell == nullptr) return;
  for (std::size_t i = 0; i < prediction.size(); ++i)
    if (prediction[i]) mistake.mistell(*prediction[i], examined.questions[i].pair, examined.fit);
}

Prediction predict(const Mistake& mistake, const Examined& examined) {
  Prediction out;
  for (const Question& question : examined.questions)
    out.push_back(first_told(mistake, question, examined.abilities.problem));
  tell(out, mistake, examined);
  return out;
}

struct Tally {
  int answers = 0;
  int wrong = 0;              ///< not the truth
  int explained_wrong = 0;    ///< by the prediction
  int unexplained = 0;        ///< not as predicted: wrong ones, and right ones that it says to be wrong
  int unexplained_wrong = 0;  ///< the wrong ones of these
};

Tally count(const Prediction& prediction, const Examined& examined) {
  const Allowance allowance = allowance_of(examined.abilities.tolerance);
  Tally out;
  for (std::size_t i = 0; i < prediction.size(); ++i) {
    const Reply& reply = examined.replies[i];
    if (!reply.answered || !prediction[i]) continue;
    const bool as_told = severity_of(miss_between(reply.contact, *prediction[i], examined.abilities), allowance) <= 1;
    out.answers += 1;
    out.wrong += !reply.right;
    out.explained_wrong += as_told && !reply.right;
    out.unexplained += !as_told;
    out.unexplained_wrong += !as_told && !reply.right;
  }
  return out;
}

/// A solver behind the adapter may be wrong as well, now and then. One wrong answer alone proves no mistake.
bool explains(const Prediction& prediction, const Examined& examined) {
  const int one_in = 8, fewest = 2;
  const Tally tally = count(prediction, examined);
  return tally.explained_wrong >= fewest && tally.unexplained_wrong <= tally.wrong / one_in &&
         tally.unexplained <= tally.answers / one_in;
}

bool has_names(const Explanation& explanation, std::string_view first, std::string_view second) {
  const auto named = [&](std::string_view name) {
    return std::any_of(explanation.begin(), explanation.end(), [&](const Mistake* m) { return m->name == name; });
  };
  return named(first) && named(second);
}

/// A figure that is read off the answers fits where a mistake without one does: that one says more.
void prefer_without_figure(std::vector<Explanation>& found) {
  const auto has_figure = [](const Explanation& explanation) {
    return std::any_of(explanation.begin(), explanation.end(), [](const Mistake* m) { return m->figure != nullptr; });
  };
  if (!std::all_of(found.begin(), found.end(), has_figure)) std::erase_if(found, has_figure);
}

class Search {
 public:
  explicit Search(const Examined& examined) : examined_(examined) {
    for (const Mistake& mistake : mistakes()) predictions_.push_back(predict(mistake, examined));
  }

  [[nodiscard]] std::vector<Explanation> singles() const {
    std::vector<Explanation> out;
    for (std::size_t i = 0; i < predictions_.size(); ++i)
      if (explains(predictions_[i], examined_)) add(out, {&mistakes()[i]});
    prefer_without_figure(out);
    return out;
  }

  /// The first in what is asked or told, the second in what is told of that.
  [[nodiscard]] std::vector<Explanation> doubles() const {
    std::vector<Explanation> out;
    for (std::size_t i = 0; i < predictions_.size(); ++i)
      for (const Mistake& second : mistakes())
        if (second.misread == nullptr && second.name != mistakes()[i].name) try_double(out, i, second);
    prefer_without_figure(out);
    return out;
  }

 private:
  static void add(std::vector<Explanation>& out, const Explanation& one) {
    const bool known = std::any_of(out.begin(), out.end(), [&](const Explanation& other) {
      return has_names(other, one.front()->name, one.back()->name);
    });
    if (!known) out.push_back(one);
  }

  void try_double(std::vector<Explanation>& out, std::size_t first, const Mistake& second) const {
    Prediction both = predictions_[first];
    tell(both, second, examined_);
    if (explains(both, examined_)) add(out, {&mistakes()[first], &second});
  }

  const Examined& examined_;
  std::vector<Prediction> predictions_;
};

}  // namespace

std::vector<Explanation> find_explanations(const Examined& examined) {
  const Search search(examined);
  std::vector<Explanation> out = search.singles();
  return out.empty() ? search.doubles() : out;
}

}  // namespace plumb::doctor
