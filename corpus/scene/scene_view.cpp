#include "corpus/scene/scene_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::scene {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double number_in(const Column* column, std::size_t i) {
  return column == nullptr ? nothing : (*column)[i];
}

Vec3<double> vector_in(const Column* column, std::size_t i) {
  return column == nullptr ? not_valid<double>() : Vec3<double>(column->vector(i));
}

/// Where the plan asks for no points, spheres still have one.
Vec3<double> point_of(const World& world, std::uint32_t c) {
  const Contacts& contacts = world.contacts;
  if (contacts.point != nullptr) return contacts.point->vector(c);
  const std::uint32_t i = contacts.pairs[c][0];
  if (world.bodies.is_sphere[i] == 0 || contacts.normal == nullptr) return not_valid<double>();
  const double reach = world.bodies.radius[i] - (*contacts.overlap)[c] / 2;
  return world.state.position->vector(i) + reach * contacts.normal->vector(c);
}

/// null where it is not finite.
Json valid_or_null(const Vec3<double>& v) {
  return v.allFinite() ? Json{v[0], v[1], v[2]} : Json();
}

Json valid_or_null(double x) {
  return std::isfinite(x) ? Json(x) : Json();
}

/// Who touches whom.
Json ends_json(std::uint32_t body1, std::uint32_t body2, const std::optional<std::uint32_t>& wall) {
  Json out;
  if (wall) {
    out["body"] = body1;
    out["wall"] = *wall;
  } else {
    out["bodies"] = {body1, body2};
  }
  return out;
}

std::optional<std::uint32_t> wall_of(const Simulation& run, std::uint32_t body2) {
  const Bodies& bodies = run.world().bodies;
  if (!bodies.is_wall(body2)) return std::nullopt;
  return body2 - static_cast<std::uint32_t>(bodies.count);
}

Json head_of(const Simulation& run) {
  return {{"time", run.time()}, {"step", run.steps()}};
}

}  // namespace

std::vector<ContactView> contacts_of(const Simulation& run) {
  const Contacts& contacts = run.world().contacts;
  std::vector<ContactView> out;
  for (const std::uint32_t c : contacts.touching) {
    const auto [i, j] = contacts.pairs[c];
    ContactView view{i,  j, {}, number_in(contacts.overlap, c), vector_in(contacts.normal, c), point_of(run.world(), c),
                     {}, {}};
    view.wall = wall_of(run, j);
    if (contacts.normal_force != nullptr) view.force = (*contacts.normal_force)[c];
    if (contacts.force != nullptr) view.total_force = contacts.force->vector(c);
    out.push_back(view);
  }
  return out;
}

std::vector<std::array<std::uint32_t, 2>> touching_pairs(const Simulation& run) {
  const Contacts& contacts = run.world().contacts;
  std::vector<std::array<std::uint32_t, 2>> out;
  for (const std::uint32_t c : contacts.touching)
    if (contacts.overlap == nullptr || (*contacts.overlap)[c] > 0) out.push_back(contacts.pairs[c]);
  out.erase(std::unique(out.begin(), out.end()), out.end());  // at several places of a wall
  return out;
}

Json contact_json(const ContactView& contact) {
  Json out = ends_json(contact.body1, contact.body2, contact.wall);
  out["overlap"] = valid_or_null(contact.overlap);
  out["normal"] = valid_or_null(contact.normal);
  out["point"] = valid_or_null(contact.point);
  if (contact.force) out["force"] = valid_or_null(*contact.force);
  if (contact.total_force) out["total_force"] = valid_or_null(*contact.total_force);
  return out;
}

Json life_json(const Simulation& run, const Life& life) {
  Json out = ends_json(life.body1, life.body2, wall_of(run, life.body2));
  out["start"] = life.start;
  out["duration"] = life.duration;
  out["greatest_overlap"] = life.greatest_overlap;
  if (life.greatest_force) out["greatest_force"] = valid_or_null(*life.greatest_force);
  out["ended"] = life.has_ended;
  return out;
}

Json energy_json(const Simulation& run) {
  Json out = head_of(run);
  out["energy"] = energies_of(run);
  return out;
}

Json contacts_json(const Simulation& run) {
  Json out = head_of(run);
  out["contacts"] = Json::array();
  for (ContactView& contact : contacts_of(run)) {
    contact.point = run.world().home(contact.point);
    out["contacts"].push_back(contact_json(contact));
  }
  return out;
}

Json touching_json(const Simulation& run) {
  const Bodies& bodies = run.world().bodies;
  Json pairs = Json::array(), walls = Json::array();
  for (const auto& [i, j] : touching_pairs(run))
    if (bodies.is_wall(j))
      walls.push_back({i, j - bodies.count});
    else
      pairs.push_back({i, j});
  Json out = head_of(run);
  out["touching"] = pairs;
  out["walls"] = walls;
  return out;
}

std::map<std::string, double> energies_of(const Simulation& run) {
  auto out = run.energy();
  if (out.empty()) return out;
  double total = 0;
  for (const auto& [owner, energy] : out) total += energy;
  out["total"] = total;
  return out;
}

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace plumb::scene
