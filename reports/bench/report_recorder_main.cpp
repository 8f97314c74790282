// plumb report-recorder: what a call of the flight recorder costs, beside a solve of `auto`, and what of the laws' findings it sees.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/doors/recording.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::int64_t pairs = 2000, passes = 60, judged = 100;
  std::uint64_t seed = 1;
  std::string folder;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("FOLDER", options.folder, "for the recorders' cases")->required();
  app.add_option("--pairs", options.pairs, "of each set that is timed")->capture_default_str()->check(refuse_count);
  app.add_option("--passes", options.passes, "over each set; the least time counts")
      ->capture_default_str()
      ->check(refuse_count);
  app.add_option("--judged", options.judged, "cases of each family that the laws judge")
      ->capture_default_str()
      ->check(refuse_count);
  declare_seed(app, options.seed);
}

class Recorder {
 public:
  explicit Recorder(const Options& options) : recorder_(plumb_recorder_open(options.folder.c_str(), nullptr)) {
    const std::string problem = plumb_recorder_problem(recorder_);
    if (!problem.empty()) throw InputFailure(problem, 0, "", "the recorder cannot keep anything");
  }
  ~Recorder() { plumb_recorder_close(recorder_); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  [[nodiscard]] plumb_recorder* get() const { return recorder_; }
  [[nodiscard]] std::uint64_t not_judged() const { return plumb_recorder_counted(recorder_).not_judged; }

 private:
  plumb_recorder* recorder_;
};

Contact<double> solve_auto(const Pair& pair) {
  static const SolveFunction<double> solve = find_method("auto")->solve;
  return solve(pair, {}, nullptr);
}

// ---- cost ----

/// What the foreign code answers: a contact, no contact with the distance and all, or no contact and nothing else.
enum class Kind { contact, distance, no_contact };

/// Pairs of a family, the bodies of those without contact moved apart along the line of centres.
struct Set {
  std::string_view name, family;
  bool is_round;  ///< exponents of 2 alone, else at least one other in each pair
  Kind kind;
  double stretch;
};
constexpr std::array sets{Set{"spheroids, contact", "spheroid", true, Kind::contact, 1},
                          Set{"ellipsoids, contact", "ellipsoid", true, Kind::contact, 1},
                          Set{"ellipsoids, distance", "ellipsoid", true, Kind::distance, 1.1},
                          Set{"spheroids, none at 1.1", "spheroid", true, Kind::no_contact, 1.1},
                          Set{"spheroids, none at 1.5", "spheroid", true, Kind::no_contact, 1.5},
                          Set{"ellipsoids, none at 1.1", "ellipsoid", true, Kind::no_contact, 1.1},
                          Set{"ellipsoids, none at 1.5", "ellipsoid", true, Kind::no_contact, 1.5},
                          Set{"exponents, contact", "superquadric", false, Kind::contact, 1},
                          Set{"exponents, distance", "superquadric", false, Kind::distance, 1.1},
                          Set{"exponents, none at 1.1", "superquadric", false, Kind::no_contact, 1.1},
                          Set{"exponents, none at 1.5", "superquadric", false, Kind::no_contact, 1.5}};

struct Call {
  Pair pair;
  plumb_recorder_body body1, body2;
  plumb_recorder_answer answer;
};

bool is_round(const Body& body) {
  return body.shape.n1 == 2 && body.shape.n2 == 2;
}

void leave_nothing(plumb_recorder_answer& answer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  answer.overlap = nan;
  std::fill_n(answer.normal, 3, nan);
  for (auto& point : answer.points) std::fill_n(point, 3, nan);
}

std::vector<Call> draw(const Set& set, const Options& options) {
  std::vector<Call> out;
  for (std::uint64_t i = 0; out.size() < static_cast<std::size_t>(options.pairs) && !interrupted(); ++i) {
    Pair pair = generate(set.family, options.seed, i).pair;
    if ((is_round(pair.body1) && is_round(pair.body2)) != set.is_round) continue;
    pair.body2.position = pair.body1.position + set.stretch * (pair.body2.position - pair.body1.position);
    const Contact<double> contact = solve_auto(pair);
    const bool touches = contact.verdict == Verdict::overlapping;
    if (contact.status != Status::converged || touches != (set.kind == Kind::contact)) continue;
    out.push_back({pair, recorder_body(pair.body1), recorder_body(pair.body2), recorder_answer(contact)});
    if (set.kind == Kind::no_contact) leave_nothing(out.back().answer);
  }
  return out;
}

/// The least of several passes, ns a call.
template <class Work>
double least_ns(const std::vector<Call>& calls, std::int64_t passes, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (std::int64_t i = 0; i < passes && !interrupted(); ++i) {
    const auto start = Clock::now();
    for (const Call& call : calls) work(call);
    least = std::min(least, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return least / static_cast<double>(calls.size());
}

const TextTable costs({{"set", "<26"},
                       {"record ns", ">10.1f"},
                       {"with begin", ">12.1f"},
                       {"auto ns", ">11.1f"},
                       {"ratio", ">9.3f"},
                       {"not judged", ">14.4f"}});

void print_cost(const Set& set, const Options& options) {
  const Recorder recorder(options);
  const std::vector<Call> calls = draw(set, options);
  const auto judge = [&](const Call& call) {
    (void)plumb_record(recorder.get(), &call.body1, &call.body2, &call.answer);
  };
  const auto begin_and_judge = [&](const Call& call) {
    plumb_recorder_begin(recorder.get(), &call.body1, &call.body2);
    judge(call);
  };
  const double alone = least_ns(calls, options.passes, judge);
  const auto made = static_cast<double>(plumb_recorder_counted(recorder.get()).calls);
  const double open = static_cast<double>(recorder.not_judged()) / made;
  const double with_begin = least_ns(calls, options.passes, begin_and_judge);
  const double of_auto =
      least_ns(calls, (options.passes + 9) / 10, [](const Call& call) { (void)solve_auto(call.pair); });
  print_line(costs.row(set.name, alone, with_begin, of_auto, alone / of_auto, open));
  flush_output();
}

// ---- agreement ----

/// Converged answers of a method, by what the laws and the recorder say.
struct Agreement {
  int answers = 0, wrong = 0, seen = 0, same_word = 0, false_alarms = 0;
};

void compare(Agreement& out, const Recorder& recorder, const Method& method, const Case& c) {
  const Contact<double> contact = method.solve(c.pair, {}, nullptr);
  if (contact.status != Status::converged) return;
  Judge judge(c.pair);
  const FindingKind law = judge.judge(Problem::common_normal, contact).finding.kind;
  const FindingKind seen = finding_kind(record(recorder.get(), c.pair, contact));
  const bool is_wrong = law != FindingKind::none, is_seen = seen != FindingKind::none;
  ++out.answers;
  out.wrong += is_wrong ? 1 : 0;
  out.seen += is_wrong && is_seen ? 1 : 0;
  out.same_word += is_wrong && law == seen ? 1 : 0;
  out.false_alarms += is_seen && !is_wrong ? 1 : 0;
}

const TextTable agreements({{"family", "<14"},
                            {"method", "<22"},
                            {"answers", ">9"},
                            {"wrong", ">8"},
                            {"seen", ">8"},
                            {"same word", ">11"},
                            {"false alarms", ">14"}});

void print_agreement(std::string_view family, std::string_view method, const Options& options) {
  const Recorder recorder(options);
  Agreement all;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(options.judged) && !interrupted(); ++i)
    compare(all, recorder, *find_method(method), generate(family, options.seed, i));
  print_line(agreements.row(family, method, all.answers, all.wrong, all.seen, all.same_word, all.false_alarms));
  flush_output();
}

int report(const Options& options) {
  print_line(costs.head());
  for (const Set& set : sets) {
    if (interrupted()) return exit_done;
    print_cost(set, options);
  }
  print_line("\n" + agreements.head());
  for (const Family& family : families())
    for (const std::string_view method : {"original_cn", "corrected_cn", "new_cn", "geometric_potential", "auto"}) {
      if (interrupted()) return exit_done;
      print_agreement(family.name, method, options);
    }
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("The flight recorder's cost a call beside auto's, and the laws' findings that it sees.",
                         "plumb report-recorder");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
