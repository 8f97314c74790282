#include "reports/kills/engines.hpp"

#include <array>
#include <fmt/format.h>
#include <functional>
#include <numeric>

#include <atomic>
#include <mutex>
#include <optional>
#include <set>

#include "corpus/command/in_parallel.hpp"
#include "properties/doors/host_modes.hpp"
#include "properties/laws/laws_convex.hpp"
#include "properties/laws/motion/path.hpp"
#include "solver/method/convex.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

bool same_bits(double a, double b) {
  return a == b || (a != a && b != b);
}

template <class Vector>
bool same_components(const Vector& a, const Vector& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

/// What both have of a converged answer; what has not converged is withheld from `own`.
bool same_answer(const Contact<double>& control, const Contact<double>& own) {
  if (control.status != own.status || control.evaluations != own.evaluations || control.iterations != own.iterations)
    return false;
  return own.status != Status::converged ||  // withheld then
         (control.verdict == own.verdict && same_bits(control.overlap, own.overlap) &&
          same_components(control.normal, own.normal) && same_components(control.point1, own.point1) &&
          same_components(control.point2, own.point2) && same_components(control.contact_point, own.contact_point));
}

/// The first failure of several threads.
class FirstFailure {
 public:
  template <class Work>
  void guard(const Work& work) {
    if (has_failed_) return;
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      has_failed_ = true;
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

/// The earliest kill of each bug, whatever the order in which threads report them.
class FirstKills {
 public:
  explicit FirstKills(std::size_t bugs) : kills_(bugs) {}

  /// Whether a kill at that run would be the earliest. What is skipped for that is later than a kill, so that the earliest is
  /// the same for any number of threads.
  [[nodiscard]] bool is_open(std::size_t i, std::uint64_t run) {
    const std::scoped_lock lock(mutex_);
    return kills_[i].run == 0 || run < kills_[i].run;
  }
  void add(std::size_t i, std::uint64_t run, const Finding& finding) {
    const std::scoped_lock lock(mutex_);
    if (kills_[i].run != 0 && kills_[i].run <= run) return;
    kills_[i].run = run;
    kills_[i].finding = fmt::format("{} ({})", name(finding.kind), finding.law);
  }
  void note_change(std::size_t i) {
    const std::scoped_lock lock(mutex_);
    kills_[i].changed = true;
  }
  [[nodiscard]] std::vector<Kill> take() { return std::move(kills_); }

 private:
  std::mutex mutex_;
  std::vector<Kill> kills_;
};

Finding finding_of(const SeededSolver& seeded, std::size_t bug, const Contact<double>& answer, Judge& judge) {
  const auto solve = [&](const Pair& related) { return seeded.solve(bug, related, Want{}, nullptr); };
  return judge.judge(Problem::common_normal, answer, solve, true).finding;
}

/// Whether the bug has a finding where the solver without one has none, or a wrong answer where that says it has none.
bool is_news(const Finding& finding, const Finding& of_control) {
  if (finding.kind == FindingKind::none || of_control.kind == FindingKind::none)
    return finding.kind != FindingKind::none;
  const bool is_flagged = finding.kind == FindingKind::nonconverged || finding.kind == FindingKind::asymmetric;
  return of_control.kind == FindingKind::nonconverged && !is_flagged;
}

/// The answer without a bug, which must be that of `auto`.
void require_auto(const Contact<double>& control, const Contact<double>& automatic, const std::string& where) {
  if (same_answer(control, automatic)) return;
  throw ControlDiffers(where + ": without a bug the library does not give the bits of auto");
}

WarmSolve with_bug(const SeededSolver& seeded, std::size_t bug) {
  return
      [&seeded, bug](const Pair& pair, const Contact<double>* last) { return seeded.solve(bug, pair, Want{}, last); };
}

std::vector<PathFinding> follow(const SeededSolver& seeded, std::size_t bug, PathJudge& judge) {
  return judge_path(judge.follow(Problem::common_normal, with_bug(seeded, bug)));
}

/// Sums of iterations and evaluations.
struct Work {
  std::uint64_t iterations = 0, evaluations = 0;
  std::vector<std::array<int, 2>> of_pairs;  ///< evaluations, iterations
};

Work work_of(const SeededSolver& seeded, std::size_t bug, const WorkSet& set) {
  Work out;
  std::optional<Contact<double>> last;
  for (const Pair& pair : set.pairs) {
    last = seeded.solve(bug, pair, Want{}, set.is_motion && last ? &*last : nullptr);
    out.iterations += static_cast<std::uint64_t>(last->iterations);
    out.evaluations += static_cast<std::uint64_t>(last->evaluations);
    out.of_pairs.push_back({last->evaluations, last->iterations});
  }
  return out;
}

bool is_beyond(std::uint64_t work, std::uint64_t control) {
  const auto x = static_cast<double>(work), of = static_cast<double>(control);
  return x < least_work * of || x > most_work * of;
}

/// How many pairs cost other work, whatever the sum.
std::size_t count_changed(const Work& work, const Work& control) {
  return std::inner_product(work.of_pairs.begin(), work.of_pairs.end(), control.of_pairs.begin(), std::size_t{0},
                            std::plus<>(), std::not_equal_to<>());
}

/// In words, where the work is not the control's; of spheres there may be none.
std::optional<std::string> deviation(const Work& work, const Work& control) {
  if (is_beyond(work.evaluations, control.evaluations) || is_beyond(work.iterations, control.iterations))
    return fmt::format("{} evaluations for {}, {} iterations for {}", work.evaluations, control.evaluations,
                       work.iterations, control.iterations);
  const std::size_t changed = count_changed(work, control), pairs = work.of_pairs.size();
  if (pairs >= many_pairs && static_cast<double>(changed) > most_changed * static_cast<double>(pairs))
    return fmt::format("{} of {} pairs cost other work", changed, pairs);
  return std::nullopt;
}

/// In words, where an answer depends on the mode or the mode does not outlive the call.
std::optional<std::string> dependence(const SeededSolver& seeded, std::size_t bug, const Pair& pair,
                                      const HostMode& mode) {
  const Contact<double> expected = seeded.solve(bug, pair, Want{}, nullptr);
  const InHostMode host(mode);
  const Contact<double> found = seeded.solve(bug, pair, Want{}, nullptr);
  if (!host.is_in_force()) return fmt::format("the host's mode is not put back: {}", mode.name);
  if (!same_answer(expected, found)) return fmt::format("other bits in another mode: {}", mode.name);
  return std::nullopt;
}

/// A case before all bugs.
struct Hunted {
  std::string name;
  Contact<double> automatic;
  std::function<Contact<double>(std::size_t bug)> solve;
  std::function<Finding(std::size_t bug, const Contact<double>&)> judge;
};

/// Case after case; what `at` gives is used by one thread.
Hunt hunt_each(const Quarry& quarry, std::size_t cases,
               const std::function<void(std::size_t, const std::function<void(const Hunted&)>&)>& at) {
  FirstKills kills(quarry.bugs.size());
  FirstFailure failure;
  std::atomic<std::uint64_t> control_findings{0};
  const auto hunt = [&](std::size_t index, const Hunted& hunted) {
    const Contact<double> control = hunted.solve(0);
    require_auto(control, hunted.automatic, hunted.name);
    const Finding of_control = hunted.judge(0, control);
    if (of_control.kind != FindingKind::none) ++control_findings;
    for (std::size_t i = 0; i < quarry.bugs.size(); ++i) {
      if (!kills.is_open(i, index + 1)) continue;
      const Contact<double> answer = hunted.solve(quarry.bugs[i]);
      if (!same_answer(answer, control)) kills.note_change(i);
      const Finding finding = hunted.judge(quarry.bugs[i], answer);
      if (is_news(finding, of_control)) kills.add(i, index + 1, finding);
    }
  };
  in_parallel(cases, quarry.threads, [&](std::size_t index) {
    failure.guard([&] { at(index, [&](const Hunted& hunted) { hunt(index, hunted); }); });
  });
  failure.rethrow();
  return {cases, kills.take(), control_findings};
}

}  // namespace

Hunt hunt_cases(const Quarry& quarry, std::size_t cases, const std::function<Case(std::size_t)>& draw) {
  return hunt_each(quarry, cases, [&](std::size_t index, const auto& hunt) {
    const Case c = draw(index);
    const auto solve = [&](std::size_t bug) { return quarry.seeded.solve(bug, c.pair, Want{}, nullptr); };
    Judge judge(c.pair, quarry.source);
    hunt({c.name, find_method("auto")->solve(c.pair, Want{}, nullptr), solve,
          [&](std::size_t bug, const Contact<double>& answer) {
            return finding_of(quarry.seeded, bug, answer, judge);
          }});
  });
}

Hunt hunt_shapes(const Quarry& quarry, std::size_t pairs, const std::function<ConvexPair(std::size_t)>& draw) {
  return hunt_each(quarry, pairs, [&](std::size_t index, const auto& hunt) {
    const ConvexPair pair = draw(index);
    const auto solve = [&](std::size_t bug) { return quarry.seeded.solve_convex(bug, pair); };
    hunt({fmt::format("pair {} of shapes", index), solve_convex(pair, {}, nullptr), solve,
          [&](std::size_t, const Contact<double>& answer) { return judge_convex(pair, answer, {}, true).finding; }});
  });
}

Hunt hunt_motions(const Quarry& quarry, const std::vector<Track>& tracks) {
  FirstKills kills(quarry.bugs.size());
  FirstFailure failure;
  std::atomic<std::uint64_t> control_findings{0};
  std::vector<std::uint64_t> before(tracks.size() + 1, 0);
  for (std::size_t t = 0; t < tracks.size(); ++t) before[t + 1] = before[t] + tracks[t].size();
  in_parallel(tracks.size(), quarry.threads, [&](std::size_t t) {
    failure.guard([&] {
      PathJudge judge(tracks[t], quarry.source);
      std::set<std::size_t> of_control;
      for (const PathFinding& found : follow(quarry.seeded, 0, judge)) of_control.insert(found.step);
      control_findings += of_control.size();
      for (std::size_t i = 0; i < quarry.bugs.size(); ++i) {
        if (!kills.is_open(i, before[t] + 1)) continue;
        for (const PathFinding& found : follow(quarry.seeded, quarry.bugs[i], judge))
          if (!of_control.contains(found.step)) kills.add(i, before[t] + found.step + 1, found.finding);
      }
    });
  });
  failure.rethrow();
  return {before.back(), kills.take(), control_findings};
}

Hunt hunt_work(const Quarry& quarry, const std::vector<WorkSet>& sets) {
  std::vector<Work> control;
  Hunt out;
  out.kills.resize(quarry.bugs.size());
  for (const WorkSet& set : sets) {
    control.push_back(work_of(quarry.seeded, 0, set));
    out.runs += set.pairs.size();
  }
  in_parallel(quarry.bugs.size(), quarry.threads, [&](std::size_t i) {
    std::uint64_t runs = 0;
    for (std::size_t s = 0; s < sets.size() && out.kills[i].run == 0; ++s) {
      runs += sets[s].pairs.size();
      const auto found = deviation(work_of(quarry.seeded, quarry.bugs[i], sets[s]), control[s]);
      if (found) out.kills[i] = {runs, sets[s].name + ": " + *found, true};
    }
  });
  return out;
}

Hunt hunt_in_modes(const Quarry& quarry, const std::vector<Pair>& pairs) {
  Hunt out{pairs.size(), std::vector<Kill>(quarry.bugs.size())};
  const auto found = [&](std::size_t bug, std::size_t i) {
    return dependence(quarry.seeded, bug, pairs[i], host_modes()[i % host_modes().size()]);
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (found(0, i)) ++out.control_findings;
    for (std::size_t b = 0; b < quarry.bugs.size(); ++b) {
      Kill& kill = out.kills[b];
      if (kill.run != 0) continue;
      if (const auto words = found(quarry.bugs[b], i)) kill = {i + 1, *words, true};
    }
  }
  return out;
}

}  // namespace plumb::reports
