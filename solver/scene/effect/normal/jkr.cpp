#include "solver/scene/effect/normal/jkr.hpp"

#include <algorithm>
#include <memory>
#include <numbers>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/hertz_contact.hpp"
#include "solver/scene/contact/relative_curvature.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

/// The law of two bodies, in x of the head.
struct Adhesive {
  double force_unit;    ///< pi w R
  double overlap_unit;  ///< s^2 / R
  double energy_unit;   ///< pi w s^2

  Adhesive(double work, double modulus, double radius) {
    using std::numbers::pi;
    const double scale = std::cbrt(pi * work * radius * radius / (8 * modulus));
    force_unit = pi * work * radius;
    overlap_unit = scale * scale / radius;
    energy_unit = pi * work * scale * scale;
  }

  [[nodiscard]] double parting() const { return -3 * overlap_unit; }

  /// x^4 - 4 x = overlap, x >= 1: y sqrt(y^2 + 4 y + 6) = sqrt(overlap + 3), y = x - 1, whose left side is convex. Newton from above.
  [[nodiscard]] double place_of(double overlap) const {
    const double wanted = std::sqrt(std::max(0.0, overlap / overlap_unit + 3));
    double y = wanted / std::sqrt(6.0);
    for (double last = 2 * y + 1; y < last;) {
      const double root = std::sqrt(y * y + 4 * y + 6);
      last = y;
      y -= (y * root - wanted) / (root + y * (y + 2) / root);
    }
    return 1 + std::max(0.0, y);
  }

  [[nodiscard]] double force(double x) const { return force_unit * (x * x * x / 6 - 1) * x * x * x; }
  [[nodiscard]] double energy(double x) const {
    return energy_unit * ((x * x * x / 15 - 2.0 / 3) * x * x * x + 1) * x * x * x * x;
  }
};

/// Of contacts that hold: R of each life, 0 of those that do not.
class Holding {
 public:
  Holding(const Jkr& jkr, World& world)
      : world_(world), hertz_factors_(world.columns.find("hertz_factor")),
        radii_(world.columns.add("jkr_radius", Jkr::name, {.of = ColumnKind::pair, .width = 1, .is_kept = true})),
        works_(by_pair(world, jkr, &Effects::jkr)),
        moduli_(world, world.effects.hertz.value_or(Hertz{}), &Effects::hertz,
                [](const Hertz& of_pair) { return of_pair.contact_modulus(); }) {}

  void begin_and_end(const ContactRange& range) const {
    auto touching = range.touching.begin();
    for (std::size_t c = range.first; c < range.end; ++c)
      if (touching != range.touching.end() && *touching == c)
        follow(*touching++);
      else
        radii_[c] = 0;
  }

  void pull(const ContactRange& range) const {
    for (const std::uint32_t c : range.touching) {
      if (!(radii_[c] > 0)) continue;
      const Adhesive law = law_of(c);
      (*world_.contacts.normal_force)[c] += law.force(law.place_of(overlap(c))) - hertz(c, 1.5);
    }
  }

  /// Less what Hertz's force alone would store.
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (const std::uint32_t c : world_.contacts.touching) {
      if (!(radii_[c] > 0)) continue;
      const Adhesive law = law_of(c);
      sum += law.energy(law.place_of(overlap(c))) - 0.4 * hertz(c, 2.5);
    }
    return sum;
  }

 private:
  [[nodiscard]] double overlap(std::size_t c) const { return (*world_.contacts.overlap)[c]; }
  [[nodiscard]] Adhesive law_of(std::size_t c) const {
    return {works_.at(c).work_of_adhesion, moduli_.at(c), radii_[c]};
  }
  [[nodiscard]] double hertz(std::size_t c, double power) const {
    return overlap(c) > 0 ? moduli_.at(c) * (*hertz_factors_)[c] * std::pow(overlap(c), power) : 0;
  }

  void follow(std::size_t c) const {
    if (radii_[c] == 0 && overlap(c) > 0 && works_.at(c).work_of_adhesion > 0) {
      const auto curvature = world_.contacts.curvature->entry(c);
      const double root = 0.75 * hertz_contact(curvature[0], curvature[1]).force_factor;
      radii_[c] = root * root;
    }
    if (radii_[c] > 0 && overlap(c) <= law_of(c).parting()) radii_[c] = 0;
  }

  World& world_;
  const Column* hertz_factors_;  ///< nullptr where the work is 0, and nothing holds
  Column& radii_;
  ByPair<Jkr> works_;
  ByPair<double> moduli_;
};

}  // namespace

Role role(const Jkr& jkr, const Scene& scene) {
  Role out;
  out.needs = {.contacts = true, .curvature = true, .normal_force = true};
  if (jkr.work_of_adhesion == 0) {
    out.off = "the work of adhesion is 0";
    return out;
  }
  if (!scene.effects.hertz)
    throw SceneError("effects.jkr", "is Hertz's contact with adhesion, and there is none: add hertz");
  const double modulus = scene.effects.hertz->contact_modulus();
  if (modulus == 0) throw SceneError("effects.jkr", "pulls bodies into each other, and the elastic force is 0");
  const double widest = greatest_radius * longest_axis(scene);
  const Adhesive law(jkr.work_of_adhesion, modulus, widest);
  out.needs.range = -law.parting();
  // Half a period about the overlap without a force, x^3 = 6, where the slope is 3/20 6^(2/3) of the units'.
  const double slope = law.force_unit / law.overlap_unit / 2;
  out.needs.fastest = std::min(collision_time(scene), std::numbers::pi * std::sqrt(least_contact_mass(scene) / slope));
  return out;
}

void install(const Jkr& jkr, World& world) {
  const auto holding = std::make_shared<const Holding>(jkr, world);
  world.contact_passes.push_back({Jkr::name, [holding](const ContactRange& range) {
                                    holding->begin_and_end(range);
                                    holding->pull(range);
                                  }});
  world.energies.push_back({Jkr::name, [holding] { return holding->energy(); }});
}

}  // namespace plumb::scene
