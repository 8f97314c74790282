// Where a local solve of two superellipsoids starts.
//
// The direction n is that in which the ellipsoids of the same semi-axes start (ellipsoids.hpp). A body with an exponent above
// 3 starts on the ray to the middle of the two ellipsoids' support points: on a flat the direction does not say where the
// point is. A rounder body starts where its normal is n.
#pragma once

#include "solver/method/auto/surface/attempts.hpp"
#include "solver/method/auto/surface/surface_equations.hpp"

namespace plumb {

/// Along which both surfaces start: the gauge coordinates of their points, or of their normals.
template <class S>
struct SurfaceRay {
  Vector3<PerBody<S>> v;
  Mask<S> is_normal;
};

/// What starts need of the ellipsoids of the same semi-axes.
template <class S>
struct SurfaceStart {
  const SuperellipsoidPair<S>& pair;

  /// A direction of any length to start from.
  [[nodiscard]] Vector3<S> direction() const {
    const Matrix3<PerBody<S>>& r = pair.rotation;
    const Vector3<PerBody<S>>& a = pair.semi_axes;
    const auto row = [&](const Vector3<PerBody<S>>& v) { return times(v, a); };
    const Vector3<PerBody<S>> x = row(r.row0), y = row(r.row1), z = row(r.row2);
    const Symmetric3<S> squares =
        sum(Symmetric3<PerBody<S>>{dot(x, x), dot(x, y), dot(x, z), dot(y, y), dot(y, z), dot(z, z)});
    // Bodies 1e17 sizes apart: the line of centres, which is the normal to rounding.
    const auto far = largest(pair.c) > tolerance::far_apart.of<S>() * pair.size;
    // Coinciding centres: a direction that favours no axis.
    const auto apart = largest(pair.c) > tolerance::coinciding.of<S>() * pair.size;
    const Vector3<S> near = adjugate(squares).matrix * blend(apart, pair.c, Vector3<S>{S(0.001), S(0.002), S(0.003)});
    const Vector3<S> v = blend(far, pair.c, near);
    const Vector3<S> n = v * (S(1) / largest(v));  // of needles the square would underflow
    return n * (S(1) / length(n));
  }

  /// n a unit vector; the arcs are the pair's or rounder ones.
  [[nodiscard]] Surfaces<S> at(const Vector3<S>& n, StartPoint kind, const SuperellipseArc<S>& inner,
                               const SuperellipseArc<S>& outer) const {
    const Vector3<PerBody<S>> q = times(to_body_axes(pair, n), pair.semi_axes);
    if (kind == StartPoint::normal) return surfaces_at<S>(pair, inner, outer, q, Mask<S>(true));
    const Vector3<PerBody<S>> u = q * inverse_length<S>(q);
    if (kind == StartPoint::chart) return surfaces_of_chart<S>(pair, inner, outer, u);
    const Mask<S> by_middle = kind == StartPoint::middle ? Mask<S>(true) : is_blocky();
    if (has_one_pair<S> && none_of(by_middle)) return surfaces_at<S>(pair, inner, outer, q, Mask<S>(true));
    const SurfaceRay<S> ray = ray_to_middle(u, by_middle);
    return surfaces_at<S>(pair, inner, outer, ray.v, ray.is_normal);
  }

  /// That of StartPoint::mixed.
  [[nodiscard]] SurfaceRay<S> mixed_ray(const Vector3<S>& n) const {
    const Vector3<PerBody<S>> q = times(to_body_axes(pair, n), pair.semi_axes);
    return ray_to_middle(q * inverse_length<S>(q), is_blocky());
  }

 private:
  [[nodiscard]] Mask<S> is_blocky() const {
    const PerBody<S> inner = select<S>(pair.inner.dual, S(0), pair.inner.nu);
    const PerBody<S> outer = select<S>(pair.outer.dual, S(0), pair.outer.nu);
    return max(inner, outer) > S(tolerance::blocky);
  }

  /// Of some bodies by the middle, of the others where the ellipsoid's point is u.
  [[nodiscard, gnu::always_inline]] SurfaceRay<S> ray_to_middle(const Vector3<PerBody<S>>& u,
                                                                const Mask<S>& by_middle) const {
    const Vector3<PerBody<S>> ray = to_middle(u);
    return {{select<S>(by_middle, ray.x, u.x), select<S>(by_middle, ray.y, u.y), select<S>(by_middle, ray.z, u.z)},
            !by_middle};
  }

  /// From each centre to the middle of the ellipsoids' support points, gauge coordinates.
  [[nodiscard]] Vector3<PerBody<S>> to_middle(const Vector3<PerBody<S>>& u) const {
    const Vector3<S> from1 = (sum(pair.rotation * times(pair.semi_axes, u)) + pair.c) * S(0.5);
    return times(pair.rotation.transposed_times(per_body(from1, from1 - pair.c)), pair.inverse_axes);
  }
};

}  // namespace plumb
