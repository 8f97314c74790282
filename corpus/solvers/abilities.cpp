#include "corpus/solvers/abilities.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

template <class Word, std::size_t N>
Word read_word(const Field& field, const std::array<Word, N>& all) {
  const std::string said = field.text();
  std::string known;
  for (const Word word : all) {
    if (said == name(word)) return word;
    known += (known.empty() ? "" : ", ") + std::string(name(word));
  }
  field.fail("is '" + said + "', must be one of " + known);
}

bool is_ellipsoid(const Superellipsoid<double>& shape) {
  return shape.n1 == 2 && shape.n2 == 2;
}

bool is_sphere(const Superellipsoid<double>& shape) {
  return is_ellipsoid(shape) && shape.semi_axes.minCoeff() == shape.semi_axes.maxCoeff();
}

bool takes(const Abilities& abilities, const Superellipsoid<double>& shape) {
  if (abilities.shapes == Shapes::spheres) return is_sphere(shape);
  if (abilities.shapes == Shapes::ellipsoids) return is_ellipsoid(shape);
  const auto [least, greatest] = abilities.exponents;
  return std::min(shape.n1, shape.n2) >= least && std::max(shape.n1, shape.n2) <= greatest;
}

bool is_bare_verdict(const Abilities& abilities, const Contact<double>& answer) {
  return abilities.apart == Apart::verdict && answer.verdict == Verdict::separated;
}

std::array<double, 2> read_exponents(const Field& field) {
  const auto out = field.numbers<2>();
  if (!(out[0] >= 1 && out[0] <= out[1])) field.fail("must be the least and the greatest, 1 or above");
  return out;
}

double read_tolerance(const Field& field) {
  const double out = field.number();
  if (!(out >= 0)) field.fail("must be 0 or above");
  return out;
}

}  // namespace

std::string_view name(Shapes shapes) {
  constexpr std::array<std::string_view, 3> names{"superellipsoids", "ellipsoids", "spheres"};
  return names[static_cast<std::size_t>(shapes)];
}

std::string_view name(Apart apart) {
  constexpr std::array<std::string_view, 3> names{"distance", "verdict", "none"};
  return names[static_cast<std::size_t>(apart)];
}

std::string_view name(Points points) {
  constexpr std::array<std::string_view, 3> names{"two", "midway", "none"};
  return names[static_cast<std::size_t>(points)];
}

bool Abilities::takes(const Pair& pair) const {
  return plumb::takes(*this, pair.body1.shape) && plumb::takes(*this, pair.body2.shape);
}

bool Abilities::claims(const Pair& pair, Verdict certified) const {
  return takes(pair) && (apart != Apart::none || certified == Verdict::overlapping);
}

Contact<double> Abilities::claimed(Contact<double> answer) const {
  const bool bare = is_bare_verdict(*this, answer);
  if (bare) {
    answer.status = Status::converged;
    answer.overlap = std::numeric_limits<double>::quiet_NaN();
  }
  if (bare || !normal) answer.normal = not_valid<double>();
  if (bare || points != Points::two) answer.point1 = answer.point2 = not_valid<double>();
  if (bare || points == Points::none) answer.contact_point = not_valid<double>();
  return answer;
}

bool Abilities::is_whole(const Contact<double>& answer) const {
  if (is_bare_verdict(*this, answer)) return true;
  const bool has_points = points == Points::two      ? answer.point1.allFinite() && answer.point2.allFinite()
                          : points == Points::midway ? answer.contact_point.allFinite()
                                                     : true;
  return std::isfinite(answer.overlap) && (!normal || answer.normal.allFinite()) && has_points;
}

Json abilities_json(const Abilities& abilities) {
  Json out;
  if (!abilities.name.empty()) out["name"] = abilities.name;
  if (!abilities.version.empty()) out["version"] = abilities.version;
  if (!abilities.licence.empty()) out["licence"] = abilities.licence;
  out["shapes"] = name(abilities.shapes);
  const auto [least, greatest] = abilities.exponents;
  if (abilities.shapes == Shapes::superellipsoids && std::isfinite(greatest)) out["exponents"] = {least, greatest};
  out["apart"] = name(abilities.apart);
  out["points"] = name(abilities.points);
  out["normal"] = abilities.normal;
  out["problem"] = name(abilities.problem);
  out["tolerance"] = abilities.tolerance;
  out["warm"] = abilities.warm;
  return out;
}

Abilities read_abilities(const Field& from) {
  from.require_object({"name", "version", "licence", "shapes", "exponents", "apart", "points", "normal", "problem",
                       "tolerance", "warm"});
  Abilities out;
  if (const auto said = from.find("name")) {
    out.name = said->text();
    if (const std::string wrong = refuse_solver_name(out.name); !wrong.empty()) said->fail(wrong);
  }
  if (const auto said = from.find("version")) out.version = said->text();
  if (const auto said = from.find("licence")) out.licence = said->text();
  if (const auto said = from.find("shapes"))
    out.shapes = read_word(*said, std::array{Shapes::superellipsoids, Shapes::ellipsoids, Shapes::spheres});
  if (const auto said = from.find("exponents")) out.exponents = read_exponents(*said);
  if (const auto said = from.find("apart"))
    out.apart = read_word(*said, std::array{Apart::distance, Apart::verdict, Apart::none});
  if (const auto said = from.find("points"))
    out.points = read_word(*said, std::array{Points::two, Points::midway, Points::none});
  if (const auto said = from.find("normal")) out.normal = said->flag();
  if (const auto said = from.find("problem"))
    out.problem = read_word(*said, std::array{Problem::common_normal, Problem::deepest_points, Problem::midway});
  if (const auto said = from.find("tolerance")) out.tolerance = read_tolerance(*said);
  if (const auto said = from.find("warm")) out.warm = said->flag();
  return out;
}

std::string refuse_solver_name(std::string_view word) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '+' || c == '-';
  };
  constexpr std::size_t most = 64;
  if (!word.empty() && word.size() <= most && std::all_of(word.begin(), word.end(), fits)) return "";
  return "must be 1 to 64 letters, digits and . _ + -";
}

}  // namespace plumb
