// Every structured binding below names all fields of its struct: one that is added later does not compile until it is
// written, and read back, here.
#include "corpus/certificate/reference_json.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "corpus/case/contract_words.hpp"

namespace plumb {
namespace {

Json number_json(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

Json number_json(const Real50& x) {
  std::array<char, 128> text{};  // 43 hexadecimal digits and an exponent
  (void)mpfr_snprintf(text.data(), text.size(), "%Ra", x.backend().data());
  return text.data();
}

template <class S>
Json numbers_json(const Vec3<S>& v) {
  return {number_json(v[0]), number_json(v[1]), number_json(v[2])};
}

Json condition_json(const Condition& condition) {
  const auto& [overlap, normal, points] = condition;
  return {{"overlap", number_json(overlap)}, {"normal", number_json(normal)}, {"points", number_json(points)}};
}

Json bounds_json(const Bounds& bounds) {
  const auto& [lower, upper] = bounds;
  return {number_json(lower), number_json(upper)};
}

template <class Item, class ToJson>
Json list_json(const std::vector<Item>& items, ToJson to_json) {
  Json out = Json::array();
  for (const Item& item : items) out.push_back(to_json(item));
  return out;
}

bool read_flag(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value().get<bool>();
}

template <class Word>
Word read_word(const Field& field, std::initializer_list<Word> words) {
  for (const Word word : words)
    if (field.text() == name(word)) return word;
  field.fail("is no word of this field");
}

Claim read_claim(const Field& field) {
  return read_word(field, {Claim::open, Claim::proved, Claim::disproved});
}

double read_double(const Field& field) {
  if (!field.value().is_string()) return field.number();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string word = field.text();
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (word != "inf" && word != "-inf") field.fail("must be a number, inf, -inf or nan");
  return word == "inf" ? infinity : -infinity;
}

Real50 read_real(const Field& field) {
  const std::string text = field.text();
  Real50 out;
  char* end = nullptr;
  const int rounded = mpfr_strtofr(out.backend().data(), text.c_str(), &end, 0, MPFR_RNDN);
  if (text.empty() || end != text.c_str() + text.size() || rounded != 0) field.fail("must be a number of 50 digits");
  return out;
}

/// `read`: read_double or read_real.
template <class S>
Vec3<S> read_vector(const Field& field, S (*read)(const Field&)) {
  return {read(field.element(0, 3, "numbers")), read(field.element(1, 3, "numbers")),
          read(field.element(2, 3, "numbers"))};
}

Condition read_condition(const Field& field) {
  return {read_double(field.member("overlap")), read_double(field.member("normal")),
          read_double(field.member("points"))};
}

Bounds read_bounds(const Field& field) {
  return {read_real(field.element(0, 2, "numbers")), read_real(field.element(1, 2, "numbers"))};
}

Ring read_ring(const Field& field) {
  return {read_vector(field.member("axis"), read_double), field.member("least_angle").number(),
          field.member("greatest_angle").number()};
}

template <class Read>
auto read_list(const Field& field, Read read) {
  std::vector<decltype(read(field))> out;
  for (const Field& element : field.elements()) out.push_back(read(element));
  return out;
}

}  // namespace

Json solution_json(const Solution& solution) {
  const auto& [solved, proved, reason, overlap, normal, point1, point2, residual, condition, bounds, normal_radius,
               points_radius] = solution;
  return {{"solved", solved},
          {"proved", proved},
          {"reason", reason},
          {"overlap", number_json(overlap)},
          {"normal", numbers_json(normal)},
          {"points", {numbers_json(point1), numbers_json(point2)}},
          {"residual", number_json(residual)},
          {"condition", condition_json(condition)},
          {"bounds", bounds_json(bounds)},
          {"normal_radius", number_json(normal_radius)},
          {"points_radius", number_json(points_radius)}};
}

Solution read_solution(const Field& field) {
  Solution out;
  out.solved = read_flag(field.member("solved"));
  out.proved = read_flag(field.member("proved"));
  out.reason = field.member("reason").text();
  out.overlap = read_real(field.member("overlap"));
  out.normal = read_vector(field.member("normal"), read_real);
  out.point1 = read_vector(field.member("points").element(0, 2, "points"), read_real);
  out.point2 = read_vector(field.member("points").element(1, 2, "points"), read_real);
  out.residual = read_real(field.member("residual"));
  out.condition = read_condition(field.member("condition"));
  out.bounds = read_bounds(field.member("bounds"));
  out.normal_radius = read_double(field.member("normal_radius"));
  out.points_radius = read_double(field.member("points_radius"));
  return out;
}

Json ring_json(const Ring& ring) {
  const auto& [axis, least_angle, greatest_angle] = ring;
  return {{"axis", numbers_json(axis)}, {"least_angle", least_angle}, {"greatest_angle", greatest_angle}};
}

Json reference_json(const Reference& reference) {
  [[maybe_unused]] const auto& [effort, verdict, overlap, common_normal, tied, close, global, unique, reason, open,
                                rings, direction, cover, meridian, nearest, cells] = reference;
  return {{"effort", name(effort)},
          {"verdict", name(verdict)},
          {"overlap", bounds_json(overlap)},
          {"common_normal", solution_json(common_normal)},
          {"tied", list_json(tied, solution_json)},
          {"close", list_json(close, solution_json)},
          {"global", name(global)},
          {"unique", name(unique)},
          {"reason", reason},
          {"open", list_json(open, numbers_json<double>)},
          {"rings", list_json(rings, ring_json)},
          {"direction", numbers_json(direction)},
          {"cells", cells}};
}

Reference read_reference(const Field& field) {
  Reference out;
  out.effort = read_word(field.member("effort"), {Effort::bounds, Effort::proof, Effort::digits});
  out.verdict = read_verdict(field.member("verdict"));
  out.overlap = read_bounds(field.member("overlap"));
  out.common_normal = read_solution(field.member("common_normal"));
  out.tied = read_list(field.member("tied"), read_solution);
  out.close = read_list(field.member("close"), read_solution);
  out.global = read_claim(field.member("global"));
  out.unique = read_claim(field.member("unique"));
  out.reason = field.member("reason").text();
  out.open = read_list(field.member("open"), [](const Field& v) { return read_vector(v, read_double); });
  out.rings = read_list(field.member("rings"), read_ring);
  out.direction = read_vector(field.member("direction"), read_real);
  out.cells = field.member("cells").count();
  return out;
}

}  // namespace plumb
