#include "solver/scene/contact/narrow_phase.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "solver/method/automatic.hpp"
#include "solver/scene/contact/contact_columns.hpp"
#include "solver/scene/contact/pair_chunk.hpp"
#include "solver/scene/contact/separation.hpp"
#include "solver/scene/threads.hpp"
#include "solver/scene/wall/meet_wall.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

using Index = std::uint32_t;

/// The deepest point of a body in a plane: the support point, in closed form. Whether they touch.
bool meet_plane(World& world, std::size_t c, Totals& round) {
  const Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const Vec3<double> into = -world.bodies.wall_normal[j - world.bodies.count];
  const double distance = into.dot(world.state.position->vector(j) - world.state.position->vector(i));
  if (distance >= world.bodies.radius[i] + contacts.range) return false;
  const Eigen::Quaterniond q = world.solver_orientation(i);
  const NormValue<double> at = support_point<double>(world.bodies.shape[i], q.conjugate() * into);
  Contact<double> answer;
  answer.overlap = at.value - distance;
  if (answer.overlap <= -contacts.range) return false;
  answer.normal = into;
  answer.point1 = world.state.position->vector(i) + q * at.gradient;
  answer.contact_point = answer.point1 - answer.overlap / 2 * into;
  if (!keep_wall_contact(world, c, answer)) ++round.failed;
  return true;
}

/// Two balls, not about one centre, in closed form. Whether they touch.
bool meet_balls(World& world, std::size_t c, Totals& round) {
  const auto [i, j] = world.contacts.pairs[c];
  const double radius1 = world.bodies.radius[i], radius2 = world.bodies.radius[j];
  const Vec3<double> centre1 = world.state.position->vector(i), centre2 = world.second_position(c);
  Contact<double> answer;
  answer.overlap = radius1 + radius2 - (centre2 - centre1).norm();
  if (answer.overlap <= -world.contacts.range) return false;
  answer.normal = (centre2 - centre1).normalized();
  answer.point1 = centre1 + radius1 * answer.normal;
  answer.point2 = centre2 - radius2 * answer.normal;
  answer.contact_point = (answer.point1 + answer.point2) / 2;
  if (!keep_contact(world, c, answer)) ++round.failed;
  return true;
}

bool are_balls(const World& world, std::size_t c) {
  const auto [i, j] = world.contacts.pairs[c];
  return world.bodies.is_sphere[i] != 0 && world.bodies.is_sphere[j] != 0 &&
         world.second_position(c) != world.state.position->vector(i);
}

/// Of body 2 the image that is nearest to body 1: the one that it can touch. Walls have none.
void set_image(World& world, std::size_t c) {
  const auto [i, j] = world.contacts.pairs[c];
  const Vec3<double> sides = world.state.box_sides->vector(0);
  const Vec3<double> apart = world.state.position->vector(j) - world.state.position->vector(i);
  for (int k = 0; k < 3; ++k)
    world.contacts.image->vector(c)[k] =
        sides[k] > 0 && !world.bodies.is_wall(j) ? -sides[k] * std::round(apart[k] / sides[k]) : 0;
}

/// Whether the balls around two bodies do.
bool may_touch(const World& world, std::size_t c) {
  const auto [i, j] = world.contacts.pairs[c];
  const double reach = world.bodies.radius[i] + world.bodies.radius[j] + world.contacts.range;
  return (world.second_position(c) - world.state.position->vector(i)).squaredNorm() <= reach * reach;
}

/// Where no warm start succeeded: a contact is never dropped because a start was bad. With normal and points as a chunk has them: curvatures
/// are those at the points.
Contact<double> solve_cold(const World& world, std::size_t c, Want want) {
  want.normal = want.points = true;
  return automatic<double>(solver_pair(world, c), want, nullptr);
}

/// Pairs of the list that follow each other. What is alike among them is asked side by side; a pair's answer depends on itself alone.
class Block {
 public:
  static constexpr std::size_t capacity = 256;

  Block(World& world, const Want& want, std::size_t first, std::size_t end, std::vector<char>& touches,
        std::vector<SolveNote>& notes)
      : world_(world), want_(want), first_(first), end_(end), touches_(touches), notes_(notes) {}

  [[nodiscard]] Totals meet() {
    for (std::size_t c = first_; c < end_; ++c) sort(c);
    in_chunks(to_ask_, [&](std::span<const Index> part) { ask(part); });
    in_chunks(to_solve_, [&](std::span<const Index> part) { solve(part); });
    for (std::size_t c = first_; c < end_; ++c) leave_charts(c);
    return round_;
  }

 private:
  struct List {
    std::array<Index, capacity> contacts;
    std::size_t count = 0;
    void add(std::size_t contact) { contacts[count++] = static_cast<Index>(contact); }
  };

  [[nodiscard]] bool touched(std::size_t c) const { return (*world_.contacts.is_pressing)[c] != 0; }

  /// A pair that touched is solved from its last answer. One that did not is first asked whether it does.
  void sort(std::size_t c) {
    const std::uint32_t j = world_.contacts.pairs[c][1];
    if (world_.contacts.image != nullptr) set_image(world_, c);
    if (world_.bodies.is_wall(j))
      sort_wall(c, j - world_.bodies.count);
    else if (!may_touch(world_, c))
      return;
    else if (are_balls(world_, c))
      touches_[c] = meet_balls(world_, c, round_) ? 1 : 0;
    else if (!touched(c) && world_.contacts.separation != nullptr && are_parted(world_, c))
      return;
    else if (!want_.is_yes_or_no() && (touched(c) || world_.contacts.range > 0))
      to_solve_.add(c);
    else
      to_ask_.add(c);
  }

  /// All places of a pair at its first: those of others, in the next block too, are left to it.
  void sort_wall(std::size_t c, std::size_t wall) {
    if (std::holds_alternative<PlaneWall>(world_.bodies.wall_shape[wall])) {
      touches_[c] = meet_plane(world_, c, round_) ? 1 : 0;
      return;
    }
    const auto& pairs = world_.contacts.pairs;
    if (c > 0 && pairs[c - 1] == pairs[c]) return;
    if (!meet_wall(world_, c, touches_, near_)) ++round_.failed;
  }

  template <class Work>
  void in_chunks(const List& list, const Work& work) {
    const std::span<const Index> all(list.contacts.data(), list.count);
    for (std::size_t k = 0; k < all.size(); k += PairChunk::capacity) {
      const std::span<const Index> part = all.subspan(k, std::min(PairChunk::capacity, all.size() - k));
      chunk_.clear();
      for (const Index c : part) chunk_.add(world_, c);
      work(part);
    }
  }

  void count(std::size_t c, const Contact<double>& answer) {
    ++round_.solves;
    round_.evaluations += answer.evaluations;
    evaluations_[c - first_] += answer.evaluations;
  }

  void ask(std::span<const Index> part) {
    chunk_.ask(want_, world_.contacts.separation != nullptr);
    for (std::size_t k = 0; k < part.size(); ++k) decide(part[k], chunk_.answer(k));
  }

  void decide(std::size_t c, const Contact<double>& answer) {
    count(c, answer);
    const bool is_answered = answer.status == Status::converged;
    if (is_answered && answer.verdict == Verdict::separated) return part(c, answer.normal);
    if (!want_.is_yes_or_no()) return to_solve_.add(c);
    if (!is_answered) ++round_.failed;
    touches_[c] = !is_answered || answer.verdict == Verdict::overlapping ? 1 : 0;
    keep_charts(world_.contacts, c, answer);
  }

  void solve(std::span<const Index> part) {
    chunk_.solve(want_);
    for (std::size_t k = 0; k < part.size(); ++k) keep(part[k], chunk_.answer(k));
  }

  /// Where no solve gave a finite answer they do what they did before, with the columns of then.
  void keep(std::size_t c, Contact<double> answer) {
    count(c, answer);
    const bool failed_warm = answer.status != Status::converged;
    if (failed_warm) count(c, answer = solve_cold(world_, c, want_));
    round_.failed_warm += failed_warm ? 1 : 0;
    round_.failed += answer.status != Status::converged ? 1 : 0;
    const bool is_answered = std::isfinite(answer.overlap), before = touched(c),
               touches = is_answered ? answer.overlap > -world_.contacts.range : before;
    if (!notes_.empty())
      notes_[c] = {.contact = static_cast<Index>(c),
                   .status = answer.status,
                   .iterations = answer.iterations,
                   .evaluations = evaluations_[c - first_],
                   .touched = before,
                   .touches = touches,
                   .failed_warm = failed_warm};
    touches_[c] = touches ? 1 : 0;
    if (!is_answered) return;
    if (!touches) return part(c, answer.normal);
    keep_charts(world_.contacts, c, answer);
    if (!keep_contact(world_, c, answer)) ++round_.failed;
  }

  void part(std::size_t c, const Vec3<double>& direction) {
    if (world_.contacts.separation != nullptr) keep_plane(world_, c, direction);
  }

  /// Where a pair that does not touch was solved last says nothing of where it will: a contact hangs on the bodies alone, and not on how the
  /// pair was known to be apart before.
  void leave_charts(std::size_t c) {
    if (world_.bodies.is_wall(world_.contacts.pairs[c][1]) || touches_[c] != 0) return;
    const auto chart = world_.contacts.chart->entry(c);
    if (!std::isnan(chart[0])) std::ranges::fill(chart, std::numeric_limits<double>::quiet_NaN());
  }

  World& world_;
  const Want& want_;
  std::size_t first_, end_;
  std::vector<char>& touches_;
  std::vector<SolveNote>& notes_;
  List to_ask_, to_solve_;
  std::array<int, capacity> evaluations_{};
  PairChunk chunk_;
  Totals round_;
  std::vector<Index> near_;  ///< triangles of a mesh
};

/// Which pairs touch, which of them overlap, and which did and no longer do.
void sort_out(Contacts& contacts, const std::vector<char>& touches) {
  contacts.touching.clear();
  contacts.pressing.clear();
  contacts.parted.clear();
  for (std::size_t c = 0; c < touches.size(); ++c) {
    double& flag = (*contacts.is_pressing)[c];
    const bool presses = touches[c] != 0 && (contacts.overlap == nullptr || (*contacts.overlap)[c] > 0);
    if (touches[c] != 0) contacts.touching.push_back(static_cast<Index>(c));
    if (presses) contacts.pressing.push_back(static_cast<Index>(c));
    if (!presses && flag != 0) contacts.parted.push_back(static_cast<Index>(c));
    flag = presses ? 1 : 0;
  }
}

}  // namespace

Body solver_body(const World& world, std::uint32_t i) {
  const Eigen::Quaterniond q = world.solver_orientation(i);
  return {world.bodies.shape[i], world.state.position->vector(i), {q.w(), q.x(), q.y(), q.z()}};
}

Pair solver_pair(const World& world, std::size_t contact) {
  const auto [i, j] = world.contacts.pairs[contact];
  Pair out{solver_body(world, i), solver_body(world, j)};
  out.body2.position = world.second_position(contact);
  return out;
}

Totals solve_contacts(World& world, const Want& want, std::vector<SolveNote>* notes) {
  const std::size_t pairs = world.contacts.pairs.size();
  std::vector<SolveNote> all(notes == nullptr ? 0 : pairs);
  std::vector<char> touches(pairs);
  follow_turns(world);
  std::vector<Totals> rounds(parts_of(pairs, Block::capacity));
  for_each_part(pairs, Block::capacity, world.threads, [&](std::size_t part, std::size_t first, std::size_t end) {
    rounds[part] = Block(world, want, first, end, touches, all).meet();
  });
  sort_out(world.contacts, touches);
  if (notes != nullptr)
    std::ranges::copy_if(all, std::back_inserter(*notes), [](const SolveNote& note) { return note.evaluations > 0; });
  Totals sum;
  for (const Totals& round : rounds) sum += round;
  return sum;
}

}  // namespace plumb::scene
