#include <array>
#include <cmath>
#include <utility>

#include "reports/document/document.hpp"
#include "reports/document/kinds_of_line.hpp"
#include "reports/document/taken_fields.hpp"

namespace plumb::reports {
namespace {

constexpr std::array kModes{"quick", "full"};
constexpr std::array kShapes{"spheroid", "ellipsoid", "superquadric"};
constexpr std::array kStarts{"auto", "geometric_potential", "centre_line"};

/// With how many answers it was asked of, and how many hold: so far none.
Json uncounted(Json what) {
  what.update({{"held", 0}, {"of", 0}});
  return what;
}

/// Each holds above the overlap ratio of the one before it, up to its own.
Json cn_bounds(const Field& field) {
  Json out = Json::array();
  double above = 0;
  for (const Field& bound : field.elements()) {
    Json one{{"above", above}};
    one.update(read_parts(bound, {{"ratio", as::positive}, {"below_deg", as::positive}}));
    if (!(one["ratio"] > above)) bound.member("ratio").fail("must be above the one before it");
    above = one["ratio"].get<double>();
    out.push_back(uncounted(std::move(one)));
  }
  if (out.empty()) field.fail("is empty");
  return out;
}

/// What is asked of the angles between the force and the normals of CN (auto) and GP (geometric_potential).
Json asked(const Field& limits) {
  Json out = read_parts(limits, {{"cn", cn_bounds}});
  out["gp"] = uncounted(read_parts(limits, {{"times", as::positive}, {"apart_deg", as::not_negative}}));
  return out;
}

Json angle(const Field& field) {
  if (!(field.number() >= 0 && field.number() <= 180)) field.fail("must lie in 0 to 180");
  return field.number();
}

/// By method; null where it has no answer.
template <Read read>
Json by_method(const Field& field) {
  if (!field.value().is_object() || field.value().empty())
    field.fail("must be an object with a number for each method");
  Json out = Json::object();
  for (const auto& [method, value] : field.value().items()) out[method] = as::or_null<read>(field.member(method));
  return out;
}

Json programs(const Field& host) {
  for (const char* name : {"ccx", "gmsh"}) static_cast<void>(host.member(name).text());
  Json out = Json::object();
  for (const auto& [name, value] : host.value().items())
    if (name != "commit") out[name] = host.member(name).text();
  return out;
}

Json poisson(const Field& field) {
  if (!(field.number() > -1 && field.number() < 0.5)) field.fail("must lie between -1 and 0.5");
  return field.number();
}

void take_fem_run(Json& out, const Field& line) {
  out.update(read_parts(line, {{"command", as::text},
                               {"host", programs},
                               {"mode", as::one_of<kModes>},
                               {"young", as::positive},
                               {"poisson", poisson},
                               {"held", as::text}}));
  out["asked"] = asked(line.member("limits"));
  out["commit"] = line.member("host").member("commit").text();
}

Json body(const Field& field) {
  const Json out = read_parts(field, {{"semi_axes", as::numbers<3>}, {"exponents", as::numbers<2>}});
  for (const Json& axis : out["semi_axes"])
    if (!(axis > 0)) field.member("semi_axes").fail("must be above 0");
  return out;
}

Json two_bodies(const Field& field) {
  return Json::array({body(field.element(0, 2, "bodies")), body(field.element(1, 2, "bodies"))});
}

void take_geometry(Json& out, const Field& line) {
  out["geometries"].push_back(read_parts(line, {{"name", as::text},
                                                {"shape", as::one_of<kShapes>},
                                                {"bodies", two_bodies},
                                                {"line_deg", as::numbers<2>},
                                                {"quaternion", as::numbers<4>}}));
}

void take_check(Json& out, const Field& line) {
  Json check =
      read_parts(line, {{"check", as::text}, {"value", as::number}, {"limit", as::number}, {"unit", as::text}});
  check["within"] = check["value"] <= check["limit"];
  out["checks"].push_back(std::move(check));
}

/// The geometry that a line names is of one before it.
void refuse_unknown(const Json& out, const Field& line) {
  const Field name = line.member("geometry");
  for (const Json& geometry : out["geometries"])
    if (geometry["name"] == name.text()) return;
  name.fail("'" + name.text() + "' is of no line before this one");
}

/// What has a reason in the place of its figures.
bool take_reason(Json& out, const Field& line) {
  refuse_unknown(out, line);
  if (!line.has("reason")) return false;
  out["unanswered"].push_back(read_parts(line, {{"kind", as::text},
                                                {"geometry", as::text},
                                                {"ratio", as::positive},
                                                {"varied", as::text, true},
                                                {"setting", as::text, true},
                                                {"start", as::text, true},
                                                {"reason", as::text}}));
  return true;
}

void take_convergence(Json& out, const Field& line) {
  if (take_reason(out, line)) return;
  out["convergence"].push_back(read_parts(line, {{"geometry", as::text},
                                                 {"ratio", as::positive},
                                                 {"varied", as::text},
                                                 {"setting", as::text},
                                                 {"turned_deg", angle},
                                                 {"force_change", as::number},
                                                 {"patch_change", as::number},
                                                 {"centre_shift", as::not_negative}}));
}

/// NaN: the method has no answer.
double angle_to(const Json& answer, const char* method) {
  const auto found = answer["angles_deg"].find(method);
  return found == answer["angles_deg"].end() || found->is_null() ? std::nan("") : found->get<double>();
}

Json counted(Json& what, bool held) {
  what["of"] = what["of"].get<int>() + 1;
  what["held"] = what["held"].get<int>() + (held ? 1 : 0);
  return held;
}

/// Whether CN is as near as is asked at this ratio; null where nothing is.
Json cn_within(Json& bounds, const Json& answer) {
  for (Json& bound : bounds)
    if (answer["ratio"] <= bound["ratio"])
      return counted(bound, angle_to(answer, "auto") < bound["below_deg"].get<double>());
  return nullptr;
}

/// Whether GP is as much further off as is asked; without an answer it is not. Null where it and CN are too near to each other.
Json gp_beyond(Json& asked, const Json& answer) {
  const Json& apart = answer["cn_to_gp_deg"];
  if (apart.is_null()) return counted(asked, false);
  if (!(apart > asked["apart_deg"])) return nullptr;
  const double times = asked["times"].get<double>();
  return counted(asked, angle_to(answer, "geometric_potential") > times * angle_to(answer, "auto"));
}

void take_fem_answer(Json& out, const Field& line) {
  if (take_reason(out, line)) return;
  Json answer = read_parts(line, {{"geometry", as::text},
                                  {"ratio", as::positive},
                                  {"force", as::not_negative},
                                  {"direction", as::numbers<3>},
                                  {"angles_deg", by_method<angle>},
                                  {"cn_to_gp_deg", as::or_null<angle>, true},
                                  {"centre_off", by_method<as::not_negative>},
                                  {"patch_radius", as::positive},
                                  {"fem_patch_radius", as::positive},
                                  {"balance", as::not_negative},
                                  {"nodes", as::count},
                                  {"iterations", as::count}});
  answer["cn_within"] = cn_within(out["asked"]["cn"], answer);
  answer["gp_beyond"] = gp_beyond(out["asked"]["gp"], answer);
  out["answers"].push_back(std::move(answer));
}

/// How many times the gap is as curved on the far side as where the pressure's centre has moved; null where that is not known.
Json bends(const Json& curvatures) {
  if (curvatures.is_null() || curvatures[2] == 0) return nullptr;
  return curvatures[0].get<double>() / curvatures[2].get<double>();
}

void take_half_space(Json& out, const Field& line) {
  if (take_reason(out, line)) return;
  Json plane = read_parts(line, {{"geometry", as::text},
                                 {"ratio", as::positive},
                                 {"start", as::one_of<kStarts>},
                                 {"start_deg", angle},
                                 {"planes", as::count},
                                 {"cn_deg", angle},
                                 {"fem_deg", as::or_null<angle>, true},
                                 {"force", as::not_negative},
                                 {"patch_radius", as::positive},
                                 {"fem_force", as::or_null<as::positive>, true},
                                 {"fem_patch", as::or_null<as::positive>, true},
                                 {"centre_off", as::or_null<as::not_negative>, true},
                                 {"curvatures", as::or_null<as::numbers<3>>, true}});
  plane["bends"] = bends(plane["curvatures"]);
  out["half_space"].push_back(std::move(plane));
}

const std::vector<Kind>& fem_kinds() {
  static const std::vector<Kind> all{{"geometry", {"name"}, take_geometry},
                                     {"check", {"check"}, take_check},
                                     {"convergence", {"geometry", "ratio", "varied", "setting"}, take_convergence},
                                     {"answer", {"geometry", "ratio"}, take_fem_answer},
                                     {"half_space", {"geometry", "ratio", "start"}, take_half_space}};
  return all;
}

}  // namespace

Json fem_json(const std::filesystem::path& file) {
  const Json empty{{"host", nullptr},
                   {"interrupted", false},
                   {"asked", nullptr},
                   {"geometries", Json::array()},
                   {"checks", Json::array()},
                   {"convergence", Json::array()},
                   {"answers", Json::array()},
                   {"half_space", Json::array()},
                   {"unanswered", Json::array()}};
  return read_kinds(file, empty, take_fem_run, fem_kinds(), "reports/fem/run");
}

}  // namespace plumb::reports
