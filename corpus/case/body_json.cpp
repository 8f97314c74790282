#include "corpus/case/body_json.hpp"

#include "corpus/case/angles.hpp"
#include "corpus/case/shape_json.hpp"

namespace plumb {

std::array<double, 4> read_orientation(const Field& orientation) {
  orientation.require_object({"quaternion_wxyz", "euler_zxz", "euler_zxz_deg"});
  const auto quaternion = orientation.find("quaternion_wxyz");
  const auto radians = orientation.find("euler_zxz"), degrees = orientation.find("euler_zxz_deg");
  if (quaternion.has_value() + radians.has_value() + degrees.has_value() == 1) {
    if (quaternion) return quaternion->numbers<4>();
    if (radians) return quaternion_from_euler(radians->numbers<3>());
    if (degrees) return quaternion_from_euler_deg(degrees->numbers<3>());
  }
  orientation.fail("must hold one of quaternion_wxyz, euler_zxz, euler_zxz_deg");
}

namespace {

/// `path`: of the shape, which may lie deeper than "shape". A sweep's radius is the outermost's.
void require_legal(const Field& field, const InputError& error, const std::string& path) {
  if (error.reason.empty()) return;
  constexpr std::string_view shape = "shape.";
  const bool is_of_shape = error.field.starts_with(shape) && !error.field.starts_with("shape.sphere_swept");
  throw FieldError(is_of_shape ? path + "." + std::string(error.field.substr(shape.size()))
                               : field.path_of(error.field),
                   std::string(error.reason));
}

}  // namespace

Body read_body(const Field& field, bool placed) {
  Body out;
  const Field shape = field.member("shape");
  out.shape = read_superellipsoid(shape);
  if (!placed) out.position = field.member("position").vector();
  out.quaternion = read_orientation(field.member("orientation"));
  require_legal(field, find_input_error({out, out}), shape.path());
  return out;
}

ConvexBody read_convex_body(const Field& field) {
  SweptShape swept = read_shape(field.member("shape"));
  const ConvexBody out{std::move(swept.shape), swept.swept_radius, field.member("position").vector(),
                       read_orientation(field.member("orientation"))};
  require_legal(field, find_input_error({out, {}}), swept.path);
  return out;
}

Json body_json(const Body& body) {
  return body_json({body.shape, 0, body.position, body.quaternion});
}

Json body_json(const ConvexBody& body) {
  Json out;
  out["shape"] = shape_json(body.shape, body.swept_radius);
  out["position"] = vector_json(body.position);
  out["orientation"]["quaternion_wxyz"] = body.quaternion;
  return out;
}

}  // namespace plumb
