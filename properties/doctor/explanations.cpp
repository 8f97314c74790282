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
    if (auto& told = prediction[i]) mistake.mistell(*told, examined.questions[i].pair, examined.fit);
}

Prediction predict(const Mistake& mistake, const Examined& examined) {
  Prediction out;
  for (const Question& question : examined.questions)
    out.push_back(first_told(mistake, question, examined.abilities.problem));
  tell(out, mistake, examined);
  return out;
}

/// Answers that a mistake is to be shown by: one is chance.
constexpr int kFewest = 2;

/// What one in so many answers may be for another reason: the solver behind the adapter is wrong as well, now and then. Two mistakes
/// together explain by chance what one does not, and get none.
constexpr int kOneIn = 8;

struct Tally {
  int of = 0;
  int unexplained = 0;  ///< not as predicted
  [[nodiscard]] bool nearly_all() const { return unexplained <= of / kOneIn; }
  void add(bool explained) { of += 1, unexplained += !explained; }
};

bool is_as_told(const Contact<double>& given, const Told& told, const Abilities& abilities) {
  return severity_of(miss_between(given, told, abilities), allowance_of(abilities.tolerance)) <= 1;
}

/// All answers, and the wrong ones by themselves.
bool explains(const Prediction& prediction, const Examined& examined, bool without_exception) {
  Tally all, wrong;
  for (std::size_t i = 0; i < prediction.size(); ++i) {
    const Reply& reply = examined.replies[i];
    const auto& told = prediction[i];
    if (!reply.answered || !told) continue;
    const bool explained = is_as_told(reply.contact, *told, examined.abilities);
    all.add(explained);
    if (!reply.right) wrong.add(explained);
  }
  return without_exception ? all.unexplained == 0 : all.nearly_all() && wrong.nearly_all();
}

/// Whether a reply can tell two predictions apart: where it is a bare verdict, by that alone.
bool tells_apart(const Reply& reply, const Told& one, const Told& other, const Abilities& abilities) {
  if (is_bare_verdict(reply.contact, abilities)) return one.contact.verdict != other.contact.verdict;
  return !is_as_told(one.contact, other, abilities);
}

/// Whether the answers show what a prediction has and another one has not.
bool shows(const Prediction& prediction, const Prediction& without, const Examined& examined) {
  Tally there;
  for (std::size_t i = 0; i < prediction.size(); ++i) {
    const Reply& reply = examined.replies[i];
    const auto &told = prediction[i], &other = without[i];
    if (!reply.answered || !told) continue;
    if (!other || tells_apart(reply, *told, *other, examined.abilities))
      there.add(is_as_told(reply.contact, *told, examined.abilities));
  }
  return there.nearly_all() && there.of - there.unexplained >= kFewest;
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
  explicit Search(const Examined& examined) : examined_(examined), truth_(predict({}, examined)) {
    for (const Mistake& mistake : mistakes()) predictions_.push_back(predict(mistake, examined));
  }

  [[nodiscard]] std::vector<Explanation> singles() const {
    std::vector<Explanation> out;
    for (std::size_t i = 0; i < predictions_.size(); ++i)
      if (explains(predictions_[i], examined_, false) && shows(predictions_[i], truth_, examined_))
        add(out, {&mistakes()[i]});
    prefer_without_figure(out);
    return out;
  }

  /// The first in what is asked or told, the second in what is told of that.
  [[nodiscard]] std::vector<Explanation> doubles() const {
    std::vector<Explanation> out;
    for (std::size_t i = 0; i < predictions_.size(); ++i)
      for (std::size_t k = 0; k < predictions_.size(); ++k)
        if (mistakes()[k].misread == nullptr && mistakes()[k].name != mistakes()[i].name) try_double(out, i, k);
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

  void try_double(std::vector<Explanation>& out, std::size_t first, std::size_t second) const {
    Prediction both = predictions_[first];
    tell(both, mistakes()[second], examined_);
    if (explains(both, examined_, true) && shows(both, truth_, examined_) &&
        shows(both, predictions_[first], examined_) && shows(both, predictions_[second], examined_))
      add(out, {&mistakes()[first], &mistakes()[second]});
  }

  const Examined& examined_;
  Prediction truth_;
  std::vector<Prediction> predictions_;
};

}  // namespace

std::vector<Explanation> find_explanations(const Examined& examined) {
  const Search search(examined);
  std::vector<Explanation> out = search.singles();
  return out.empty() ? search.doubles() : out;
}

}  // namespace plumb::doctor
