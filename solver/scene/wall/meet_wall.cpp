#include "solver/scene/wall/meet_wall.hpp"

#include <cmath>
#include <limits>

#include "solver/scene/contact/contact_columns.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

constexpr std::size_t most_places = 8;

/// A body and a wall, and the wall's places in the list.
struct BodyAndWall {
  World& world;
  std::size_t first;
  std::uint32_t i = world.contacts.pairs[first][0], j = world.contacts.pairs[first][1];
  const WallShape& shape = world.bodies.wall_shape[j - world.bodies.count];
  std::size_t places = places_of(shape);
  Vec3<double> wall_point = world.state.position->vector(j);
  Eigen::Quaterniond wall_axes = world.state.orientation_of(j);

  [[nodiscard]] BodyAtWall body() const {
    return {world.bodies.shape[i], wall_axes.conjugate() * Vec3<double>(world.state.position->vector(i) - wall_point),
            wall_axes.conjugate() * world.solver_orientation(i), world.bodies.radius[i], world.contacts.range};
  }
  /// Where a contact was in the step before: its point and its normal in the wall's axes. NaN where there was none.
  [[nodiscard]] Eigen::Map<Vec3<double>> last_place(std::size_t k) const {
    return Eigen::Map<Vec3<double>>(world.contacts.chart->entry(first + k).data());
  }
  [[nodiscard]] Eigen::Map<Vec3<double>> last_into(std::size_t k) const {
    return Eigen::Map<Vec3<double>>(world.contacts.chart->entry(first + k).data() + 3);
  }
  [[nodiscard]] double& is_pressing(std::size_t k) const { return (*world.contacts.is_pressing)[first + k]; }
};

/// What a place remembers of a contact that is another one.
void forget_place(const BodyAndWall& at, std::size_t k) {
  for (Column& column : at.world.columns)
    if (column.kind().forgets) std::ranges::fill(column.entry(at.first + k), column.kind().initial);
  at.is_pressing(k) = 0;
}

/// Which touch is in which place: none, or its number.
class Places {
 public:
  Places(const BodyAndWall& at, const BodyAtWall& body, std::span<const Touch> touches)
      : at_(at), body_(body), touches_(touches) {
    of_place_.fill(none);
    while (place_nearest()) {
    }
    for (std::size_t t = 0; t < touches_.size(); ++t)
      if (!is_placed_[t]) place_new(t);
  }

  static constexpr std::size_t none = most_places;
  [[nodiscard]] std::size_t touch_at(std::size_t place) const { return of_place_[place]; }

 private:
  /// How far a touch is from where a contact was: NaN where there was none.
  [[nodiscard]] double way(std::size_t t, std::size_t place) const {
    const Vec3<double> now = body_.centre + touches_[t].reach;
    return (now - at_.last_place(place)).norm() + body_.radius * (touches_[t].into - at_.last_into(place)).norm();
  }

  /// Of all that are near where one was, the nearest.
  bool place_nearest() {
    double least = body_.radius;
    std::size_t touch = none, place = none;
    for (std::size_t t = 0; t < touches_.size(); ++t)
      for (std::size_t k = 0; k < at_.places && !is_placed_[t]; ++k)
        if (of_place_[k] == none && way(t, k) < least) least = way(t, k), touch = t, place = k;
    if (touch != none) put(touch, place);
    return touch != none;
  }

  /// Where nothing was, or else where something was that is no longer.
  void place_new(std::size_t t) {
    for (const bool is_left : {false, true})
      for (std::size_t k = 0; k < at_.places; ++k) {
        if (of_place_[k] != none || (!is_left && !std::isnan(at_.last_place(k)[0]))) continue;
        if (is_left) forget_place(at_, k);
        return put(t, k);
      }
  }
  void put(std::size_t t, std::size_t place) {
    of_place_[place] = t;
    is_placed_[t] = true;
  }

  const BodyAndWall& at_;
  const BodyAtWall& body_;
  std::span<const Touch> touches_;
  std::array<std::size_t, most_places> of_place_{};
  std::array<bool, most_places> is_placed_{};
};

/// Whether its patch, where there is one, was found.
bool keep_touch(const BodyAndWall& at, const BodyAtWall& body, std::size_t k, const Touch& touch) {
  at.last_place(k) = body.centre + touch.reach;
  at.last_into(k) = touch.into;
  const Vec3<double> into = at.wall_axes * touch.into;
  Contact<double> answer;
  answer.overlap = touch.overlap;
  answer.normal = into;
  answer.point1 = at.world.state.position->vector(at.i) + at.wall_axes * touch.reach;
  answer.point2 = answer.point1 - answer.overlap * into;
  answer.contact_point = answer.point1 - answer.overlap / 2 * into;
  return keep_wall_contact(at.world, at.first + k, answer);
}

void leave_place(const BodyAndWall& at, std::size_t k) {
  std::ranges::fill(at.world.contacts.chart->entry(at.first + k), std::numeric_limits<double>::quiet_NaN());
}

/// The six planes of a room, each in a place of its own.
bool meet_room(const BodyAndWall& at, const BoxWall& room, std::vector<char>& touches) {
  const BodyAtWall body = at.body();
  bool is_complete = true;
  for (std::size_t k = 0; k < at.places; ++k) {
    const Vec3<double> into = (k % 2 == 0 ? -1.0 : 1.0) * Vec3<double>::Unit(static_cast<int>(k / 2));
    const double distance = into.dot(room.half_extents.cwiseProduct(into) - body.centre);
    if (distance >= body.radius + body.range) continue;
    const BodyAtWall::Reach reach = body.along(into);
    const double overlap = reach.height - distance;
    if (overlap <= -body.range) continue;
    is_complete &= keep_touch(at, body, k, {overlap, into, reach.point});
    touches[at.first + k] = 1;
  }
  return is_complete;
}

}  // namespace

bool meet_wall(World& world, std::size_t first, std::vector<char>& touches, std::vector<std::uint32_t>& scratch) {
  const BodyAndWall at{world, first};
  if (const auto* room = std::get_if<BoxWall>(&at.shape); room != nullptr && room->side == Side::inside)
    return meet_room(at, *room, touches);
  const BodyAtWall body = at.body();
  Touches found;
  find_touches(at.shape, body, scratch, found);
  bool is_complete = found.is_complete();
  if (!is_complete && found.all().empty()) {  // as before, with the columns of then
    for (std::size_t k = 0; k < at.places; ++k) touches[first + k] = at.is_pressing(k) != 0 ? 1 : 0;
    return false;
  }
  const Places places(at, body, found.all());
  for (std::size_t k = 0; k < at.places; ++k) {
    const std::size_t touch = places.touch_at(k);
    if (touch == Places::none) {
      leave_place(at, k);
      continue;
    }
    touches[first + k] = 1;
    is_complete &= keep_touch(at, body, k, found.all()[touch]);
  }
  return is_complete;
}

}  // namespace plumb::scene
