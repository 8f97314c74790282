#include "fuzz/hunt/hunt.hpp"

#include <algorithm>

#include "corpus/command/interrupt.hpp"
#include "fuzz/hunt/cells.hpp"
#include "fuzz/hunt/guide.hpp"
#include "fuzz/hunt/inputs.hpp"
#include "properties/laws/laws.hpp"
#include "solver/reference/meter.hpp"

namespace plumb::hunting {
namespace {

/// Inputs in the unit of their size and at the origin, before others: what fails there fails for more users.
constexpr std::uint64_t kAtHome = 50'000;

/// Before anything is made of anything, and one in so many ever after: no corner is out of reach.
constexpr std::uint64_t kDrawnFirst = 200;
constexpr double kDrawn = 0.2, kCrossed = 0.15;

/// Of one proof (solver/reference/meter.hpp), some seconds: a pair that takes longer is passed over.
constexpr std::int64_t kMostWork = 2'000'000'000;

class Hunt {
 public:
  Hunt(const Solver& solver, const HuntOptions& options)
      : solver_(solver), options_(options), guide_(solver.abilities, options.accuracy),
        layouts_(layouts_for(solver.abilities)), begin_(std::chrono::steady_clock::now()) {}

  Hunted run() {
    while (!out_.found && !is_over()) try_one(next());
    out_.cells = cells_.size();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_over() const {
    if (interrupted() || is_given_up(solver_)) return true;
    if (options_.inputs) return out_.inputs >= *options_.inputs;
    return std::chrono::steady_clock::now() - begin_ >= options_.time;
  }

  [[nodiscard]] Input next() {
    Stream stream("hunt", options_.seed, out_.inputs++);
    Input input = made(stream);
    if (out_.inputs <= kAtHome) bring_home(input);
    return input;
  }

  [[nodiscard]] Input made(Stream& stream) const {
    if (cells_.empty() || out_.inputs <= kDrawnFirst || stream.chance(kDrawn)) return drawn(layouts_, stream);
    Input input = cells_.pick(stream);
    const Input& other = cells_.pick(stream);
    if (other.layout == input.layout && stream.chance(kCrossed))
      input.bytes = cross(*input.layout, input.bytes, other.bytes, stream);
    else
      mutate(*input.layout, input.bytes, stream);
    return input;
  }

  void try_one(const Input& input) {
    const Case c = case_of(input, solver_.abilities);
    if (!solver_.abilities.takes(c.pair)) return;
    const Contact<double> second = guide_.second(c.pair);
    if (!solver_.abilities.claims(c.pair, second.verdict)) return;
    ++out_.answered;
    const Heat heat = asked(c.pair, second);
    const Cell cell = cell_of(c.pair, second.overlap, heat);
    const bool is_suspect = heat.error > 1;
    if (is_suspect && may_stop(heat.looks_like) && cells_.is_worth_a_proof(cell)) judge(c);
    // One that is still here was acquitted, or would be: nothing is to be made of how wrong it looked.
    cells_.add(cell, input, is_suspect ? 0 : heat.error);
  }

  /// Of a solver without an answer as well.
  [[nodiscard]] Heat asked(const Pair& pair, const Contact<double>& second) {
    try {
      const Contact<double> answer = solver_.abilities.claimed(solver_.solve(pair, Want{}, nullptr));
      const Heat heat = guide_.of(pair, answer, second);
      if (answer.verdict == second.verdict) {
        out_.worst_angle_deg = std::max(out_.worst_angle_deg, heat.angle_deg);
        out_.worst_overlap = std::max(out_.worst_overlap, heat.overlap);
      }
      return heat;
    } catch (const NoAnswer& none) {
      return {finding_of(none).kind, wrong_altogether};
    }
  }

  /// A status is what it is; what else an answer only looks like may turn out as any other kind.
  [[nodiscard]] bool may_stop(FindingKind looks_like) const {
    return looks_like != FindingKind::nonconverged || options_.kinds.stops(FindingKind::nonconverged);
  }

  void judge(const Case& c) {
    ++out_.judged_pairs;
    try {
      const reference::WorkAllowance allowance(kMostWork);
      Judge judge(c.pair);
      JudgedAnswer judged = solve_and_judge(judge, c.pair, solver_, options_.accuracy);
      if (!options_.kinds.stops(judged.judgement.finding)) return;
      out_.found = c;
      out_.judged = std::move(judged);
    } catch (const reference::WorkExceeded&) {  // nothing is known of it
    }
  }

  const Solver& solver_;
  const HuntOptions& options_;
  Guide guide_;
  std::vector<const Layout*> layouts_;
  std::chrono::steady_clock::time_point begin_;
  Cells cells_;
  Hunted out_;
};

}  // namespace

Hunted hunt(const Solver& solver, const HuntOptions& options) {
  return Hunt(solver, options).run();
}

}  // namespace plumb::hunting
