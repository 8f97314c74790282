#include "fuzz/layouts/decode_contact.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "fuzz/layouts/layout_fields.hpp"
#include "properties/generators/draft.hpp"
#include "solver/pose.hpp"
#include "solver/shape/chart.hpp"

namespace plumb {
namespace {

using namespace layout;
using Wide = long double;

/// Faces, edges and corners of the cube of chart directions.
Vec3<Wide> near_direction(std::uint32_t v) {
  constexpr std::array<int, 3> digit{0, 1, -1};
  const Vec3<Wide> w(digit[v % 3], digit[v / 3 % 3], digit[v / 9 % 3]);
  return w.isZero() ? Vec3<Wide>::UnitZ() : Vec3<Wide>(w.normalized());
}

Wide tilt(Bytes bytes, std::size_t body) {
  const std::uint32_t v = read(bytes, body + 12, 2);
  if (read(bytes, body + 14, 1) % 4 == 3) return static_cast<Wide>(v) / 65535;
  if (v >= 256) return log_magnitude(v);
  return v % 16 == 0 ? 0 : std::pow(10.0L, -static_cast<Wide>(v % 16));
}

Vec3<Wide> chart_direction(Bytes bytes, std::size_t body) {
  const Vec3<Wide> w = near_direction(read(bytes, body + 1, 1));
  const Wide by = tilt(bytes, body);
  if (by == 0) return w;
  const Vec3<Wide> across = w.unitOrthogonal();
  const auto [c, s] = cos_sin_deg(angle(bytes, body + 16));
  return w * std::cos(by) + (across * c + w.cross(across) * s) * std::sin(by);
}

/// Where the contact is on a body, in body axes.
struct TouchPlace {
  Vec3<Wide> point, normal;
};

TouchPlace place_on(const Superellipsoid<double>& shape, const Vec3<Wide>& w) {
  const Superellipsoid<Wide> wide{shape.semi_axes.cast<Wide>(), shape.n1, shape.n2};
  const SurfacePoint<Wide> at = surface_point<Wide>(wide, CubePoint<Wide>::of(w));
  return {at.point, at.normal};
}

Quaternion spin_about(const Vec3<double>& axis, Wide degrees) {
  const auto [c, s] = cos_sin_deg(degrees / 2);
  const Vec3<double> v = axis * static_cast<double>(s);
  return {static_cast<double>(c), v[0], v[1], v[2]};
}

/// Takes u to -n. Where they are all but opposite by the other way round, so that a tilt of 1e-15 is not lost.
Quaternion facing(const Vec3<double>& u, const Vec3<double>& n) {
  if (u.dot(n) <= 0) return align(u, -n);
  const Vec3<double> across = u.unitOrthogonal();
  return product(align(-u, -n), {0, across[0], across[1], across[2]});
}

Superellipsoid<double> in_unit(const Superellipsoid<double>& shape, double unit, ContactShapes shapes) {
  const bool keeps = shapes == ContactShapes::all;
  return {shape.semi_axes * unit, keeps ? shape.n1 : 2, keeps ? shape.n2 : 2};
}

}  // namespace

BuiltContact decode_contact(Bytes bytes, ContactShapes shapes) {
  const double unit = read_unit(bytes, 64);
  const auto raw1 = read_shape(bytes, 0, nullptr);
  const auto shape1 = in_unit(raw1, unit, shapes), shape2 = in_unit(read_shape(bytes, kBodySize, &raw1), unit, shapes);
  const TouchPlace at1 = place_on(shape1, chart_direction(bytes, 0)),
                   at2 = place_on(shape2, chart_direction(bytes, kBodySize));
  const auto q1 = quaternion_from_degrees(angle(bytes, 68), angle(bytes, 72), angle(bytes, 76));
  const Mat3<Wide> r1 = rotation<Wide>(q1);
  const Vec3<Wide> normal = r1 * at1.normal;
  BuiltContact out;
  out.layout = shapes == ContactShapes::all ? "contact-1" : "ellipsoid-1";
  out.normal = normal.cast<double>();
  const auto q2 = product(spin_about(out.normal, angle(bytes, 56)), facing(at2.normal.cast<double>(), out.normal));
  const Wide overlap =
      read_overlap_ratio(bytes, 60) * std::min(shape1.semi_axes.minCoeff(), shape2.semi_axes.minCoeff());
  out.overlap = static_cast<double>(overlap);
  out.pair = {{shape1, Vec3<double>::Zero(), q1}, {shape2, Vec3<double>::Zero(), q2}};
  out.pair.body1.position = read_origin(bytes, 66, size_of(out.pair));
  const Vec3<Wide> offset = r1 * at1.point - normal * overlap - rotation<Wide>(q2) * at2.point;
  out.pair.body2.position = (out.pair.body1.position.cast<Wide>() + offset).cast<double>();
  return out;
}

Case contact_case(const BuiltContact& built, Bytes bytes) {
  Case c;
  c.name = "decoded bytes";
  c.pair = built.pair;
  c.provenance =
      Json{{"layout", built.layout}, {"bytes", hex(bytes.first(std::min(bytes.size(), kContactLayoutSize)))}};
  return c;
}

}  // namespace plumb
