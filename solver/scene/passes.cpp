#include "solver/scene/passes.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

#include "solver/scene/threads.hpp"

namespace plumb::scene {
namespace {

using Clock = std::chrono::steady_clock;

void clear_forces(World& world) {
  world.state.force->fill(0);
  if (world.state.torque != nullptr) world.state.torque->fill(0);
  for (Column* column : {world.contacts.normal_force, world.contacts.stiffness, world.contacts.force})
    if (column != nullptr) column->fill(0);
}

/// What contacts remember, of those that have ended.
void forget(const Contacts& contacts, std::vector<Column*>& histories) {
  for (Column* column : histories)
    for (const std::uint32_t c : contacts.parted) std::ranges::fill(column->entry(c), column->kind().initial);
}

std::span<const std::uint32_t> within(const std::vector<std::uint32_t>& rising, std::size_t first, std::size_t end) {
  return {std::ranges::lower_bound(rising, first), std::ranges::lower_bound(rising, end)};
}

/// So many that what they do stays in the cache from one pass to the next.
constexpr std::size_t range_size = 512;

/// What contacts do, and then, one after the other, what that adds to their bodies: the same sums with any number of threads.
class ContactForces {
 public:
  explicit ContactForces(World& world) : world_(world), passes_(world.contact_passes), steps_(passes_.size() + 1) {}

  void act() {
    const std::size_t pairs = world_.contacts.pairs.size();
    is_shared_ = are_shared(pairs, range_size, world_.threads);
    if (is_shared_) waiting_.resize(world_.contacts.touching.size());
    spent_.resize(parts_of(pairs, range_size) * steps_);
    const auto start = Clock::now();
    for_each_part(pairs, range_size, world_.threads, [&](std::size_t part, std::size_t first, std::size_t end) {
      act(first, end, std::span(spent_).subspan(part * steps_, steps_));
    });
    share(Clock::now() - start);
    for (std::size_t k = 0; is_shared_ && k < waiting_.size(); ++k)
      world_.act(world_.contacts.touching[k], waiting_[k]);
  }

 private:
  /// A range of the list, and onto the bodies where no other thread is at work.
  void act(std::size_t first, std::size_t end, std::span<Clock::duration> spent) {
    const Contacts& contacts = world_.contacts;
    std::array<Action, range_size> actions;
    const ContactRange range{first, end, within(contacts.touching, first, end), within(contacts.pressing, first, end),
                             actions};
    for (const std::uint32_t c : range.touching) range.action(c) = Action::none();
    auto start = Clock::now();
    const auto lap = [&start] {
      const auto now = Clock::now();
      return now - std::exchange(start, now);
    };
    for (std::size_t k = 0; k < passes_.size(); ++k) {
      passes_[k].run(range);
      spent[k] = lap();
    }
    auto place = static_cast<std::size_t>(range.touching.data() - contacts.touching.data());
    for (const std::uint32_t c : range.touching) {
      range.action(c) += world_.along_normal(c, (*contacts.normal_force)[c]);
      if (is_shared_)
        waiting_[place++] = range.action(c);
      else
        world_.act(c, range.action(c));
    }
    spent.back() = lap();
  }

  /// Of the time that has passed, each pass has what it has of the time that all threads spent.
  void share(std::chrono::duration<double> passed) {
    const std::chrono::duration<double> spent = std::accumulate(spent_.begin(), spent_.end(), Clock::duration());
    if (spent.count() == 0) return;
    for (std::size_t k = 0; k < spent_.size(); ++k)
      if (const std::size_t pass = k % steps_; pass < passes_.size())
        passes_[pass].seconds += spent_[k] / spent * passed.count();
  }

  World& world_;
  std::vector<ContactPass>& passes_;
  std::size_t steps_;  ///< of a range: its passes, and what follows
  bool is_shared_ = false;
  std::vector<Action> waiting_;         ///< of the contacts that touch, in their order
  std::vector<Clock::duration> spent_;  ///< by ranges and their steps
};

}  // namespace

void run_all(std::vector<Pass>& passes) {
  for (Pass& pass : passes) {
    const auto start = Clock::now();
    pass.run();
    pass.spent += Clock::now() - start;
  }
}

void append(std::vector<Pass>& passes, std::vector<Pass> more) {
  std::ranges::move(more, std::back_inserter(passes));
}

std::vector<Pass> contact_stage(World& world, const Plan& plan) {
  std::vector<Pass> stage;
  std::vector<Column*> histories;
  for (Column& column : world.columns)
    if (column.kind().forgets) histories.push_back(&column);
  if (!histories.empty())
    stage.push_back({"contacts", [&world, histories]() mutable { forget(world.contacts, histories); }});
  stage.push_back({"motion", [&world] { clear_forces(world); }});
  if (!plan.needs.normal_force) return stage;
  stage.push_back({"contacts", [forces = std::make_shared<ContactForces>(world)] { forces->act(); }});
  return stage;
}

std::vector<Pass> take_closing_passes(World& world) {
  std::vector<Pass> passes = std::exchange(world.body_passes, {});
  append(passes, std::exchange(world.closing_passes, {}));
  return passes;
}

}  // namespace plumb::scene
