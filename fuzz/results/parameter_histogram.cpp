#include "fuzz/results/parameter_histogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "fuzz/results/counts.hpp"
#include "solver/diagnosis.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

constexpr std::array kAspectEdges{1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0};
// Apart to 1e-9, touching, and overlapping by decades.
constexpr std::array kOverlapEdges{-1.0, -1e-1, -1e-2, -1e-3, -1e-9, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 1e-1, 0.5};
constexpr std::array kExponentEdges{
    1.1, 1.5, 2.0, std::bit_cast<double>(std::bit_cast<std::uint64_t>(2.0) + 1), 3.0, 4.0, 6.0, 8.0, 12.0, 20.0, 40.0};
constexpr std::array kTiltEdges{1e-6, 1e-3, 0.1, 1.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 89.0, 89.999};

double aspect_of(const Pair& pair) {
  const auto of_body = [](const Body& b) { return b.shape.semi_axes.maxCoeff() / b.shape.semi_axes.minCoeff(); };
  return std::max(of_body(pair.body1), of_body(pair.body2));
}

double overlap_of(const Pair& pair, const Reference& reference) {
  const double smaller = std::min(pair.body1.shape.semi_axes.maxCoeff(), pair.body2.shape.semi_axes.maxCoeff());
  return static_cast<double>(reference.overlap.lower + reference.overlap.upper) / 2 / smaller;
}

double exponent_of(const Pair& pair) {
  const std::array all{pair.body1.shape.n1, pair.body1.shape.n2, pair.body2.shape.n1, pair.body2.shape.n2};
  return *std::max_element(all.begin(), all.end(),
                           [](double a, double b) { return std::abs(std::log(a / 2)) < std::abs(std::log(b / 2)); });
}

double tilt_of(const Pair& pair) {
  const Vec3<double> z1 = rotation<double>(pair.body1.quaternion).col(2);
  const Vec3<double> z2 = rotation<double>(pair.body2.quaternion).col(2);
  return angle_deg(z1, z1.dot(z2) < 0 ? Vec3<double>(-z2) : z2);
}

double value_of(Property property, const Pair& pair, const Reference& reference) {
  switch (property) {
    case Property::aspect: return aspect_of(pair);
    case Property::overlap: return overlap_of(pair, reference);
    case Property::exponent: return exponent_of(pair);
    case Property::tilt: break;
  }
  return tilt_of(pair);
}

Json cell_json(const std::pair<int, int>& at, const AtlasCell& c) {
  return {at.first, at.second, c.answers, c.judged, c.failures, c.not_converged, c.iterations};
}

int read_edge(const Field& field, Property property) {
  const std::uint64_t cell = read_count(field);
  if (cell >= scale_of(property).cells()) field.fail("is no cell of " + scale_of(property).title);
  return static_cast<int>(cell);
}

/// As cell_json() writes it.
std::pair<std::pair<int, int>, AtlasCell> read_cell(const Field& field, const AtlasMap& map) {
  const auto at = [&](std::size_t i) { return field.element(i, 7, "counts"); };
  const AtlasCell cell{read_count(at(2)), read_count(at(3)), read_count(at(4)), read_count(at(5)), read_count(at(6))};
  if (cell.answers == 0 || cell.judged > cell.answers || cell.failures > cell.judged) field.fail("does not add up");
  return {{read_edge(at(0), map.x), read_edge(at(1), map.y)}, cell};
}

}  // namespace

std::size_t Scale::cell_of(double x) const {
  return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), x) - edges.begin());
}

std::string Scale::label(std::size_t cell) const {
  if (cell == 0) return fmt::format("below {:g}", edges.front());
  if (cell == edges.size()) return fmt::format("{:g} and more", edges.back());
  // One step above 2 prints as 2: the cell of 2 itself.
  if (fmt::format("{:g}", edges[cell - 1]) == fmt::format("{:g}", edges[cell])) return fmt::format("{:g}", edges[cell]);
  return fmt::format("{:g}..{:g}", edges[cell - 1], edges[cell]);
}

Scale scale_of(Property property) {
  switch (property) {
    case Property::aspect: return {"aspect, longest / shortest", kAspectEdges};
    case Property::overlap: return {"overlap / smaller size", kOverlapEdges};
    case Property::exponent: return {"exponent furthest from 2", kExponentEdges};
    case Property::tilt: break;
  }
  return {"angle of the z axes, deg", kTiltEdges};
}

Place place_in_atlas(const Pair& pair, const Reference& reference) {
  Place place{};
  for (std::size_t i = 0; i < kProperties; ++i) {
    const auto property = static_cast<Property>(i);
    place[i] = static_cast<std::uint8_t>(scale_of(property).cell_of(value_of(property, pair, reference)));
  }
  return place;
}

void AtlasCell::merge(const AtlasCell& other) {
  answers += other.answers;
  judged += other.judged;
  failures += other.failures;
  not_converged += other.not_converged;
  iterations += other.iterations;
}

void Atlas::add(const Place& place, const AtlasCell& answer) {
  for (std::size_t i = 0; i < maps_.size(); ++i)
    maps_[i][{place[static_cast<std::size_t>(kAtlasMaps[i].x)], place[static_cast<std::size_t>(kAtlasMaps[i].y)]}]
        .merge(answer);
}

void Atlas::merge(const Atlas& other) {
  for (std::size_t i = 0; i < maps_.size(); ++i)
    for (const auto& [at, cell] : other.maps_[i]) maps_[i][at].merge(cell);
}

Json Atlas::to_json() const {
  Json json = Json::object();
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    Json& cells = json[std::string(kAtlasMaps[i].name)] = Json::array();
    for (const auto& [at, cell] : maps_[i]) cells.push_back(cell_json(at, cell));
  }
  return json;
}

void Atlas::read(const Field& field) {
  for (std::size_t i = 0; i < maps_.size(); ++i)
    for (const Field& c : field.member(kAtlasMaps[i].name).elements()) {
      const auto [at, cell] = read_cell(c, kAtlasMaps[i]);
      maps_[i][at] = cell;
    }
}

}  // namespace plumb
