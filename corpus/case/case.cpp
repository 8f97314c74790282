#include "corpus/case/case.hpp"

#include <cmath>

#include "corpus/case/angles.hpp"
#include "corpus/case/body_json.hpp"
#include "corpus/case/contract_words.hpp"
#include "corpus/case/shape_json.hpp"
#include "corpus/json/fields.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 2> case_formats{"plumb/case-1", "plumb/case-2"};

void require_format(const Field& root) {
  root.require_object({"format", "name", "bodies", "placement", "motion", "expect", "provenance"});
  require_word(root.member("format"), case_formats);
}

Field require_body(Field field) {
  field.require_object({"shape", "position", "orientation"});
  return field;
}

Vec3<double> read_placement(const Field& placement, const Pair& pair) {
  placement.require_object({"line_deg", "overlap_ratio"});
  const auto line = placement.member("line_deg").numbers<2>();
  const Field ratio = placement.member("overlap_ratio");
  if (!(ratio.number() < 1)) ratio.fail("must be below 1");
  const Vec3<Real50> direction = line_direction_deg(line[0], line[1]);
  const FirstTouch<Real50> touch = first_touch<Real50>(pair, direction);
  if (!touch.solved) placement.fail("no first touch found along this line");
  const Real50 distance = touch.distance * (1 - Real50(ratio.number()));
  Vec3<double> position;
  for (int i = 0; i < 3; ++i) position[i] = static_cast<double>(pair.body1.position[i] + distance * direction[i]);
  if (!position.allFinite()) placement.fail("puts body 2 out of range");
  return position;
}

std::optional<std::string> read_word(const Field& expect, std::string_view key,
                                     std::span<const std::string_view> words) {
  const auto field = expect.find(key);
  if (!field) return std::nullopt;
  require_word(*field, words);
  return field->text();
}

std::array<double, 2> read_interval(const Field& field) {
  const auto interval = field.numbers<2>();
  if (interval[0] > interval[1]) field.fail("lower bound above the upper one");
  return interval;
}

double read_radius(const Field& expect, const Field& field) {
  if (!expect.has("normal")) field.fail("says nothing without normal");
  if (field.number() < 0) field.fail("must not be negative");
  return field.number();
}

Vec3<double> read_direction(const Field& field) {
  const Vec3<double> direction = field.vector();
  if (direction.isZero(0)) field.fail("must not be zero");
  return direction;
}

Expect read_expect(const Field& field) {
  field.require_object({"method", "status", "verdict", "finding", "overlap", "normal", "normal_radius", "points"});
  Expect out;
  if (const auto method = field.find("method")) out.method = method->text();
  out.status = read_word(field, "status", status_words());
  out.verdict = read_word(field, "verdict", verdict_words());
  out.finding = read_word(field, "finding", finding_words());
  if (const auto overlap = field.find("overlap")) out.overlap = read_interval(*overlap);
  if (const auto normal = field.find("normal")) out.normal = read_direction(*normal);
  if (const auto radius = field.find("normal_radius")) out.normal_radius = read_radius(field, *radius);
  if (const auto points = field.find("points"))
    out.points = {points->element(0, 2, "points").vector(), points->element(1, 2, "points").vector()};
  return out;
}

Json read_extra(const Json& root) {
  Json extra;
  for (const auto& [key, value] : root.items())
    if (key.starts_with("x_")) extra[key] = value;
  return extra;
}

}  // namespace

Pair read_pair(const Field& root) {
  const Field bodies = root.member("bodies");
  const auto placement = root.find("placement");
  const Field second = bodies.element(1, 2, "bodies");
  if (placement && second.has("position"))
    placement->fail("stands instead of bodies[1].position: give only one of them");
  Pair pair{read_body(require_body(bodies.element(0, 2, "bodies"))),
            read_body(require_body(second), placement.has_value())};  // without a position when a placement gives it
  if (placement) pair.body2.position = read_placement(*placement, pair);
  return pair;
}

Json bodies_json(const Pair& pair) {
  return {body_json(pair.body1), body_json(pair.body2)};
}

namespace {

Json bodies_json(const ConvexPair& pair) {
  return {body_json(pair.body1), body_json(pair.body2)};
}

/// Where every shape may stand, a misspelt one is refused with their names.
void require_shapes(const Field& bodies) {
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto shape = bodies.element(i, 2, "bodies").find("shape")) require_a_shape(*shape);
}

/// The first of the two that is no superellipsoid.
std::optional<Field> find_other_shape(const Field& bodies) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto shape = bodies.element(i, 2, "bodies").find("shape");
    if (shape && is_other_shape(*shape)) return shape;
  }
  return std::nullopt;
}

ConvexPair read_convex_pair(const Field& root) {
  for (const char* key : {"placement", "motion"})
    if (const auto field = root.find(key)) field->fail("is for two superellipsoids");
  const Field bodies = root.member("bodies");
  const std::array both{bodies.element(0, 2, "bodies"), bodies.element(1, 2, "bodies")};
  const ConvexPair out{read_convex_body(require_body(both[0])), read_convex_body(require_body(both[1]))};
  // Each is legal by itself.
  const InputError error = find_input_error(out);
  if (!error.reason.empty())
    throw FieldError(both[error.body == 1 ? 1 : 0].path_of(error.field), std::string(error.reason));
  return out;
}

void read_bodies(Case& out, const Field& root, CaseShapes shapes) {
  const bool is_first_format = root.member("format").text() == case_formats[0];
  if (!is_first_format && shapes == CaseShapes::every) require_shapes(root.member("bodies"));
  const auto other = find_other_shape(root.member("bodies"));
  if (!other) {
    out.pair = read_pair(root);
    if (const auto motion = root.find("motion")) out.pair.motion = motion->vector();
    return;
  }
  if (is_first_format) other->fail("is no superellipsoid: takes \"format\": \"plumb/case-2\"");
  if (shapes == CaseShapes::superellipsoids)
    other->fail("is no superellipsoid: not taken here (plumb solve, certify, check and replay take it)");
  out.convex = read_convex_pair(root);
}

Case read_case(const Json& tree, CaseShapes shapes) {
  const Field root(tree);
  require_format(root);
  Case out;
  if (const auto name = root.find("name")) out.name = name->text();
  read_bodies(out, root, shapes);
  if (const auto expect = root.find("expect")) out.expect = read_expect(*expect);
  if (const auto provenance = root.find("provenance")) out.provenance = provenance->value();
  out.extra = read_extra(tree);
  return out;
}

Json expect_json(const Expect& expect) {
  Json out;
  if (expect.method) out["method"] = *expect.method;
  if (expect.status) out["status"] = *expect.status;
  if (expect.verdict) out["verdict"] = *expect.verdict;
  if (expect.finding) out["finding"] = *expect.finding;
  if (expect.overlap) out["overlap"] = *expect.overlap;
  if (expect.normal) out["normal"] = vector_json(*expect.normal);
  if (expect.normal_radius) out["normal_radius"] = *expect.normal_radius;
  if (expect.points) out["points"] = {vector_json((*expect.points)[0]), vector_json((*expect.points)[1])};
  return out;
}

}  // namespace

bool Expect::empty() const {
  return expect_json(*this).is_null();
}

Case parse_case(const std::string& text, const std::string& file, int line, CaseShapes shapes) {
  try {
    return read_case(read_json(text), shapes);
  } catch (const FieldError& error) {
    throw InputFailure(file, line, error.field, error.what());
  }
}

std::string format_case(const Case& c) {
  Json out;
  out["format"] = case_formats[c.convex ? 1 : 0];
  out["name"] = c.name;
  out["bodies"] = c.convex ? bodies_json(*c.convex) : bodies_json(c.pair);
  if (!c.pair.motion.isZero(0)) out["motion"] = vector_json(c.pair.motion);
  if (!c.expect.empty()) out["expect"] = expect_json(c.expect);
  if (!c.provenance.is_null()) out["provenance"] = c.provenance;
  for (const auto& [key, value] : c.extra.items()) out[key] = value;
  return write_json(out);
}

}  // namespace plumb
