#include "corpus/certificate/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/certificate/reference_json.hpp"
#include "corpus/json/decimal.hpp"
#include "corpus/json/fields.hpp"
#include "solver/method/convex.hpp"
#include "solver/reference/condition/condition_proof.hpp"
#include "solver/reference/condition/nearby.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb {
namespace {

Json decimals_json(const Vec3<Real50>& v, int digits) {
  Json out = Json::array();
  for (int i = 0; i < 3; ++i) out.push_back(decimal(v[i], digits, Rounding::nearest));
  return out;
}

/// The radius about the printed decimals: the proof's, and half a unit in each component's last place (5 10^-digits of it).
std::string radius_text(const Real50& radius, const Real50& length, int digits) {
  const Real50 printed = pow(Real50(10), -digits) * 5 * length;
  const Real50 slack = 1 + pow(Real50(10), -40);  // for the two operations
  return decimal(Real50((radius + printed) * slack), 3, Rounding::up);
}

/// Nothing where there is no radius.
void put_normal(Json& out, const Vec3<Real50>& normal, double radius, int digits) {
  if (!(radius <= 1)) return;
  const Real50 r(radius);
  out["normal"] = decimals_json(normal, digits);
  out["normal_radius"] = radius_text(r, 2, digits);
}

void put_points(Json& out, const Vec3<Real50>& point1, const Vec3<Real50>& point2, double radius, int digits) {
  if (!std::isfinite(radius)) return;
  const Real50 length = 2 * std::max(point1.cwiseAbs().maxCoeff(), point2.cwiseAbs().maxCoeff());
  out["points"] = Json::array({decimals_json(point1, digits), decimals_json(point2, digits)});
  out["points_radius"] = radius_text(Real50(radius), length, digits);
}

void put_solution(Json& out, const Solution& found, int digits) {
  if (!found.proved) return;
  put_normal(out, found.normal, found.normal_radius, digits);
  put_points(out, found.point1, found.point2, found.points_radius, digits);
}

Json bounds_json(const Bounds& bounds, int digits) {
  Json out = Json::object();
  if (isfinite(bounds.lower)) out["lower"] = decimal(bounds.lower, digits, Rounding::down);
  if (isfinite(bounds.upper)) out["upper"] = decimal(bounds.upper, digits, Rounding::up);
  return out;
}

Json condition_in_words(const Condition& condition) {
  const auto factor = [](double value) { return std::isinf(value) ? Json("infinite") : Json(value); };
  return {{"overlap", factor(condition.overlap)},
          {"normal", factor(condition.normal)},
          {"points", factor(condition.points)}};
}

Json others_json(const std::vector<Solution>& others, int digits) {
  Json out = Json::array();
  for (const Solution& other : others) {
    Json one{{"overlap", bounds_json(other.bounds, digits)}};
    put_solution(one, other, digits);
    if (other.solved) one["condition"] = condition_in_words(other.condition);
    out.push_back(std::move(one));
  }
  return out;
}

Json rings_json(const std::vector<Ring>& rings) {
  Json out = Json::array();
  for (const Ring& ring : rings) out.push_back(ring_json(ring));
  return out;
}

/// A ball without bounds is absent.
Json solution_set_json(const reference::SolutionSet& set) {
  Json out{{"epsilons", reference::rounding_epsilons}};
  if (std::isfinite(set.delta)) out["overlap_change"] = set.delta;
  if (std::isfinite(set.normal_radius)) {
    out["normal"] = vector_json(set.normal);
    out["normal_radius"] = set.normal_radius;
  }
  if (std::isfinite(set.points_radius)) {
    out["points"] = {vector_json(set.point1), vector_json(set.point2)};
    out["points_radius"] = set.points_radius;
  }
  out["complete"] = set.complete;
  return out;
}

Verdict verdict_of(const Bounds& overlap) {
  if (overlap.lower > 0) return Verdict::overlapping;
  return overlap.upper < 0 ? Verdict::separated : Verdict::undecided;
}

void add_row(std::string& out, std::string_view label, std::string_view text) {
  out += fmt::format("  {:<12} {}\n", label, text);
}

void add_text(std::string& out, std::string_view label, const Json& object, const char* key) {
  if (object.contains(key)) add_row(out, label, object[key].get<std::string>());
}

void add_vector(std::string& out, std::string_view label, const Json& vector) {
  for (const Json& component : vector) {
    const auto text = component.get<std::string>();
    add_row(out, &component == &vector.front() ? label : "", (text.front() == '-' ? "" : " ") + text);
  }
}

void add_geometry(std::string& out, const Json& object) {
  if (object.contains("distance")) {
    add_text(out, "distance >=", object["distance"], "lower");
    add_text(out, "distance <=", object["distance"], "upper");
  }
  if (object.contains("overlap")) {
    add_text(out, "overlap >=", object["overlap"], "lower");
    add_text(out, "overlap <=", object["overlap"], "upper");
  }
  if (object.contains("normal")) {
    add_vector(out, "normal", object["normal"]);
    add_row(out, "  within", object["normal_radius"].get<std::string>() + " rad");
  }
  if (!object.contains("points")) return;
  add_vector(out, "point 1", object["points"][0]);
  add_vector(out, "point 2", object["points"][1]);
  add_text(out, "  within", object, "points_radius");
}

void add_condition(std::string& out, const Json& certificate) {
  if (!certificate.contains("condition")) return;
  const auto list = [&](const char* field) {
    std::string text;
    for (const auto& [key, value] : certificate[field].items())
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key,
                          value.is_string() ? value.get<std::string>() : fmt::format("{:.3g}", value.get<double>()));
    return text;
  };
  add_row(out, "condition", list("condition"));
  if (certificate.contains("condition_claims")) add_row(out, "  these are", list("condition_claims"));
  if (!certificate.contains("solutions_within")) return;
  const Json& set = certificate["solutions_within"];
  const auto radius = [&](const char* key) {
    return set.contains(key) ? fmt::format("{:.3g}", set[key].get<double>()) : std::string("any");
  };
  add_row(out, fmt::format("  {} epsilon", set["epsilons"].get<double>()),
          fmt::format("normal within {} rad, points within {}", radius("normal_radius"), radius("points_radius")));
}

void add_rings(std::string& out, const Json& certificate) {
  if (!certificate.contains("rings")) return;
  for (const Json& ring : certificate["rings"]) {
    const auto axis = ring["axis"].get<std::array<double, 3>>();
    add_row(
        out, "ring",
        fmt::format("{:.9f} .. {:.9f} rad", ring["least_angle"].get<double>(), ring["greatest_angle"].get<double>()));
    add_row(out, "  about", fmt::format("({:.9f}, {:.9f}, {:.9f})", axis[0], axis[1], axis[2]));
  }
}

void add_others(std::string& out, const Json& certificate, const char* list, std::string_view label) {
  if (!certificate.contains(list)) return;
  for (const Json& other : certificate[list]) {
    add_row(out, label, other.value("kind", ""));
    add_geometry(out, other);
  }
}

}  // namespace

void put_overlap(Json& out, const Bounds& overlap, int digits) {
  out["verdict"] = name(verdict_of(overlap));
  out["overlap"] = bounds_json(overlap, digits);
}

void put_condition_claims(Json& out, const Pair& pair, const Solution& found) {
  using namespace reference;
  ConditionProof proof = certify_condition(pair, found);
  if (is_beyond_first_order(std::max(found.condition.normal, found.condition.points))) {
    const SolutionSet set = enclose_solutions(pair, found.normal, rounding_epsilons);
    if (proof.overlap == ConditionClaim::open)
      proof.overlap = certify_overlap_condition(pair, set, found.condition.overlap);
    out["solutions_within"] = solution_set_json(set);
  }
  const NearbyAnswers nearby = nearby_answers(pair, found, rounding_epsilons);
  out["nearby"] = {{"epsilons", rounding_epsilons}, {"normal", nearby.normal}, {"points", nearby.points}};
  out["condition_claims"] = {
      {"overlap", name(proof.overlap)}, {"normal", name(proof.normal)}, {"points", name(proof.points)}};
}

void put_reference(Json& out, const Reference& found, int digits) {
  put_overlap(out, found.overlap, digits);
  put_solution(out, found.common_normal, digits);
  out["unique"] = name(found.unique);
  out["global"] = name(found.global);
  out["tied"] = others_json(found.tied, digits);
  if (!found.close.empty()) out["close"] = others_json(found.close, digits);
  if (!found.rings.empty()) out["rings"] = rings_json(found.rings);
  if (!found.open.empty()) out["open_cells"] = found.open.size();
  if (!found.reason.empty()) out["reason"] = found.reason;
  out["digits"] = digits;
  if (found.common_normal.solved) out["condition"] = condition_in_words(found.common_normal.condition);
}

void put_problem(Json& out, const Solution& found, int digits) {
  out["unique"] = name(found.proved ? Claim::proved : Claim::open);
  if (!found.reason.empty()) out["reason"] = found.reason;
  if (!found.proved) return;
  put_overlap(out, found.bounds, digits);
  put_solution(out, found, digits);
  out["condition"] = condition_in_words(found.condition);
}

void put_first_touch(Json& out, const FirstTouchProof& found, int digits) {
  out["global"] = name(found.proved ? Claim::proved : Claim::open);
  if (!found.reason.empty() && !out.contains("reason")) out["reason"] = found.reason;
  out["distance"] = bounds_json(found.distance, digits);
}

void put_convex(Json& out, const ConvexPair& pair, int digits) {
  const Contact<double> guess = solve_convex(pair, {}, nullptr);
  const reference::ConvexBounds found = reference::bound_overlap(pair, guess.normal, kConvexCells);
  put_overlap(out, {found.lower, found.upper}, digits);
  out["unique"] = name(Claim::open);
  out["reason"] = what_is_open(pair, found);
}

void put_stationary(Json& out, const StationarySet& found, int digits) {
  out["stationary"] = Json::array();
  for (const StationaryPair& pair : found.pairs) {
    Json one{{"kind", name(pair.kind)}, {"overlap", bounds_json({pair.overlap_lower, pair.overlap_upper}, digits)}};
    put_normal(one, pair.normal, pair.normal_radius, digits);
    put_points(one, pair.point1, pair.point2, pair.points_radius, digits);
    out["stationary"].push_back(std::move(one));
  }
  out["complete"] = name(found.complete ? Claim::proved : Claim::open);
  if (!found.reason.empty()) out["complete_reason"] = found.reason;
}

std::string certificate_table(const Json& certificate) {
  std::string out = certificate["name"].get<std::string>() + "\n";
  add_text(out, "problem", certificate, "problem");
  add_text(out, "verdict", certificate, "verdict");
  add_geometry(out, certificate);
  for (const char* claim : {"unique", "global", "reason"}) add_text(out, claim, certificate, claim);
  add_rings(out, certificate);
  add_condition(out, certificate);
  add_others(out, certificate, "tied", "tied with");
  add_others(out, certificate, "close", "close to");
  add_others(out, certificate, "stationary", "stationary");
  add_text(out, "complete", certificate, "complete");
  add_text(out, "reason", certificate, "complete_reason");
  add_text(out, "proof", certificate, "proof");
  add_row(out, "time", fmt::format("{:.3g} ms", certificate["timing"]["ms"].get<double>()));
  return out;
}

}  // namespace plumb
