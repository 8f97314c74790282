#include "corpus/case/body_json.hpp"

#include "corpus/case/angles.hpp"

namespace plumb {
namespace {

Superellipsoid<double> read_shape(const Field& shape) {
  shape.require_object({"superellipsoid"});
  const Field fields = shape.member("superellipsoid");
  fields.require_object({"semi_axes", "exponents"});
  Superellipsoid<double> out;
  out.semi_axes = fields.member("semi_axes").vector();
  if (const auto exponents = fields.find("exponents")) {
    const auto n = exponents->numbers<2>();
    out.n1 = n[0];
    out.n2 = n[1];
  }
  return out;
}

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

void require_legal(const Field& field, const Body& body) {
  const InputError error = find_input_error({body, body});
  if (!error.reason.empty()) throw FieldError(field.path_of(error.field), std::string(error.reason));
}

}  // namespace

Body read_body(const Field& field, bool placed) {
  Body out;
  out.shape = read_shape(field.member("shape"));
  if (!placed) out.position = field.member("position").vector();
  out.quaternion = read_orientation(field.member("orientation"));
  require_legal(field, out);
  return out;
}

Json body_json(const Body& body) {
  Json shape;
  shape["semi_axes"] = vector_json(body.shape.semi_axes);
  shape["exponents"] = {body.shape.n1, body.shape.n2};
  Json out;
  out["shape"]["superellipsoid"] = shape;
  out["position"] = vector_json(body.position);
  out["orientation"]["quaternion_wxyz"] = body.quaternion;
  return out;
}

}  // namespace plumb
