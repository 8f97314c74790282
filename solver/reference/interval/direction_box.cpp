#include "solver/reference/interval/direction_box.hpp"

#include <cmath>
#include <utility>

namespace plumb::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The m-norm of (x, y), x and y >= 0, with its derivatives g, and the s = g / x that second derivatives are made of.
template <class I>
struct PairNorm {
  I norm, gx, gy, sx, sy;

  [[nodiscard]] PairNorm exchanged() const { return {norm, gy, gx, sy, sx}; }
};

// With t = y / x: gx = (1 + t^m)^(-1/n), gy = t^(m-1) gx, norm = x (1 + t^m) gx.
template <class I>
PairNorm<I> pair_norm_at(const I& x, const I& y, const DualExponent<I>& m, double n) {
  if (!(high(x) > 0) && !(high(y) > 0)) {
    const I any = hull<I>(0, 1), beyond = hull<I>(0, infinity);
    return {I(0.0), any, any, beyond, beyond};
  }
  if (n == 2) {
    const I norm = root<I>(I(square<I>(x) + square<I>(y))), s = I(1.0) / norm;
    return {norm, x * s, y * s, s, s};
  }
  if (high(x) < high(y)) return pair_norm_at<I>(y, x, m, n).exchanged();
  if (!(high(y) > 0)) return {x, I(1.0), I(0.0), I(1.0) / x, I(n > 2 ? infinity : 0.0)};
  const I t = y / x, ratio = power<I>(t, m.minus_one), sum = I(1.0) + t * ratio;
  const I gx = power<I>(sum, I(I(-1.0) / I(n))), gy = ratio * gx;
  return {x * sum * gx, gx, gy, gx / x, gy / y};
}

template <class I>
bool is_narrow(const I& x) {
  return low(x) > 0 && high(x) < low(x) * (1 + 1e-9);
}

// g grows with its own coordinate and falls with the other, the norm grows with both; g / x falls with both for m <= 2, and
// for m > 2 it is (x / norm)^(m-2) / norm.
template <class I>
PairNorm<I> pair_norm_range(const I& x, const I& y, const DualExponent<I>& m, double n) {
  if (is_narrow<I>(x) && is_narrow<I>(y)) return pair_norm_at<I>(x, y, m, n);
  const I x0 = low_end<I>(x), x1 = high_end<I>(x), y0 = low_end<I>(y), y1 = high_end<I>(y);
  const PairNorm<I> least = pair_norm_at<I>(x0, y0, m, n), most = pair_norm_at<I>(x1, y1, m, n);
  const PairNorm<I> along_x = pair_norm_at<I>(x1, y0, m, n), along_y = pair_norm_at<I>(x0, y1, m, n);
  PairNorm<I> out{hull<I>(least.norm, most.norm), hull<I>(along_y.gx, along_x.gx), hull<I>(along_x.gy, along_y.gy),
                  hull<I>(most.sx, least.sx), hull<I>(most.sy, least.sy)};
  if (n >= 2) return out;
  if (!is_positive(out.norm)) {
    out.sx = out.sy = hull<I>(0, infinity);
    return out;
  }
  out.sx = hull<I>(I(along_y.sx * along_y.norm), I(along_x.sx * along_x.norm)) / out.norm;
  out.sy = hull<I>(I(along_x.sy * along_x.norm), I(along_y.sy * along_y.norm)) / out.norm;
  return out;
}

/// Gradient and Hessian of the norm N(q).
template <class I>
struct NormBox {
  IVec3<I> gradient;
  IMat3<I> hessian;
};

/// |q|: the Hessian is (1 - g g') / |q| with g = q / |q|.
template <class I>
NormBox<I> euclidean_box(const IVec3<I>& q) {
  std::array<I, 3> least2, most2;
  I norm2(0.0);
  for (int i = 0; i < 3; ++i) {
    const I s = square<I>(q[i]);
    least2[static_cast<std::size_t>(i)] = low_end<I>(s);
    most2[static_cast<std::size_t>(i)] = high_end<I>(s);
    norm2 += s;
  }
  const I norm = root<I>(norm2);
  NormBox<I> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto share = [](const I& own, const I& others) {
      return high(own) > 0 ? I(root<I>(I(own / (own + others)))) : I(0.0);
    };
    const I size = hull<I>(share(least2[i], I(most2[j] + most2[k])), share(most2[i], I(least2[j] + least2[k])));
    out.gradient[static_cast<int>(i)] = signed_like<I>(size, q[static_cast<int>(i)]);
  }
  const IVec3<I>& g = out.gradient;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      out.hessian(i, j) = out.hessian(j, i) =
          (i == j ? I(square<I>(g[(i + 1) % 3]) + square<I>(g[(i + 2) % 3])) : I(-g[i] * g[j])) / norm;
  return out;
}

// N = |(r, z)|_m1, r = |(x, y)|_m2: each Hessian of a pair is (m-1) / norm times (sx y gy, -gx gy, sy x gx).
template <class I>
NormBox<I> nested_box(const EnclosedBody<I>& body, const IVec3<I>& q) {
  const I x = magnitude<I>(q[0]), y = magnitude<I>(q[1]), z = magnitude<I>(q[2]);
  const PairNorm<I> inner = pair_norm_range<I>(x, y, body.m2, body.n2);
  const PairNorm<I> outer = pair_norm_range<I>(inner.norm, z, body.m1, body.n1);
  const I gx = signed_like<I>(inner.gx, q[0]), gy = signed_like<I>(inner.gy, q[1]), gz = signed_like<I>(outer.gy, q[2]);
  const I inside = body.m2.minus_one * outer.sx, outside = body.m1.minus_one / outer.norm;
  const I rr = outside * outer.sx * z * outer.gy, rz = -(outside * outer.gx * gz);
  NormBox<I> out;
  out.gradient << outer.gx * gx, outer.gx * gy, gz;
  IMat3<I>& h = out.hessian;
  h(0, 0) = rr * square<I>(gx) + inside * inner.sx * y * inner.gy;
  h(1, 1) = rr * square<I>(gy) + inside * inner.sy * x * inner.gx;
  h(0, 1) = h(1, 0) = rr * gx * gy - inside * gx * gy;
  h(0, 2) = h(2, 0) = rz * gx;
  h(1, 2) = h(2, 1) = rz * gy;
  h(2, 2) = outside * outer.sy * inner.norm * outer.gx;
  return out;
}

template <class I>
BodyBox<I> body_box(const EnclosedBody<I>& body, const IVec3<I>& direction) {
  const IVec3<I>& a = body.semi_axes;
  const IVec3<I> q{a[0] * direction[0], a[1] * direction[1], a[2] * direction[2]};
  NormBox<I> n = body.is_ellipsoid() ? euclidean_box<I>(q) : nested_box<I>(body, q);
  for (int i = 0; i < 3; ++i) {
    n.gradient[i] *= a[i];
    for (int j = 0; j < 3; ++j) n.hessian(i, j) *= a[i] * a[j];
  }
  return {direction, n.gradient, n.hessian};
}

/// frame^-1 d times det(frame), and that determinant.
template <class I>
struct LocalDirection {
  IVec3<I> w;
  I determinant;
};

template <class I>
LocalDirection<I> local_direction(const Mat3<double>& frame, const IVec3<I>& d) {
  const auto minor = [&](int i, int j) {  // cofactor (i, j) of the frame
    const auto at = [&](int r, int c) { return I(frame((i + r) % 3, (j + c) % 3)); };
    return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
  };
  LocalDirection<I> out;
  for (int j = 0; j < 3; ++j) out.w[j] = minor(0, j) * d[0] + minor(1, j) * d[1] + minor(2, j) * d[2];
  out.determinant = I(frame(0, 0)) * minor(0, 0) + I(frame(1, 0)) * minor(1, 0) + I(frame(2, 0)) * minor(2, 0);
  return out;
}

}  // namespace

template <class I>
ChartedPair<I>::ChartedPair(const EnclosedPair<I>& enclosed_pair, const DirectionFrame& f)
    : pair(enclosed_pair), base(f.base) {
  for (int i = 0; i < 9; ++i) columns(i / 3, i % 3) = I(f.columns(i / 3, i % 3));
  frame = base < 0 ? columns : IMat3<I>(body(static_cast<std::size_t>(base)).rotation * columns);
  for (std::size_t b = 0; b < 2; ++b) {
    const IMat3<I> back = body(b).rotation.transpose();
    if (base < 0)
      from_base[b] = back;
    else if (static_cast<int>(b) == base || f.aligned)
      from_base[b] = Mat3<double>::Identity().template cast<I>();
    else
      from_base[b] = back * body(1 - b).rotation;
    to_body[b] = base >= 0 && (static_cast<int>(b) == base || f.aligned) ? columns : IMat3<I>(from_base[b] * columns);
  }
  to_body[1] = -to_body[1];
}

EnclosedPair<RoughInterval> rounded(const EnclosedPair<Interval18>& pair) {
  const auto number = [](const Interval18& x) { return RoughInterval((low(x) + high(x)) / 2); };
  const auto body = [&](const EnclosedBody<Interval18>& b) -> EnclosedBody<RoughInterval> {
    return {b.semi_axes.unaryExpr(number),
            b.n1,
            b.n2,
            DualExponent<RoughInterval>(b.n1),
            DualExponent<RoughInterval>(b.n2),
            b.rotation.unaryExpr(number),
            b.axis};
  };
  return {body(pair.body1), body(pair.body2), pair.centre.unaryExpr(number), pair.exponent};
}

template <class I>
DirectionBox<I> direction_box(const ChartedPair<I>& pair, const IVec3<I>& v) {
  return {v,
          {body_box<I>(pair.pair.body1, IVec3<I>(pair.to_body[0] * v)),
           body_box<I>(pair.pair.body2, IVec3<I>(pair.to_body[1] * v))}};
}

template <class I>
Functional<I>::Functional(const ChartedPair<I>& pair, std::array<IVec3<I>, 2> along, const IVec3<I>& world)
    : k(std::move(along)), offset(pair.frame.transpose() * cross_product<I>(world, pair.pair.centre)) {
  for (std::size_t b = 0; b < 2; ++b)
    if (const auto axis = pair.body(b).axis) k[b][*axis] = I(0.0);
}

template <class I>
Functional<I> functional(const ChartedPair<I>& pair, const Vec3<double>& c) {
  const IVec3<I> along = enclosed<I>(c);
  return {pair,
          {pair.from_base[0] * along, pair.from_base[1] * along},
          pair.base < 0 ? along : IVec3<I>(pair.body(static_cast<std::size_t>(pair.base)).rotation * along)};
}

template <class I>
Functional<I> axis_functional(const ChartedPair<I>& pair, int axis) {
  const auto own = static_cast<std::size_t>(axis / 3), other = 1 - own;
  const IVec3<I> along = pair.body(own).rotation.col(axis % 3);
  std::array<IVec3<I>, 2> k;
  k[own] = enclosed<I>(Vec3<double>::Unit(axis % 3));
  k[other] = pair.body(other).rotation.transpose() * along;
  return {pair, std::move(k), along};
}

template <class I>
I value_of(const DirectionBox<I>& box, const Functional<I>& phi) {
  I out = -dot<I>(phi.offset, box.v);
  for (std::size_t b = 0; b < 2; ++b) {
    const BodyBox<I>& body = box.bodies[b];
    out += dot<I>(body.point, cross_product<I>(body.direction, phi.k[b]));
  }
  return out;
}

// Where a factor is zero for sure the entry of the Hessian, infinite perhaps, is left out: with u = 0 along an axis as well
// as near it, the product has no such part.
template <class I>
I slope_of(const ChartedPair<I>& pair, const DirectionBox<I>& box, const Functional<I>& phi, int component) {
  I out = -phi.offset[component];
  for (std::size_t b = 0; b < 2; ++b) {
    const BodyBox<I>& body = box.bodies[b];
    const IVec3<I>& k = phi.k[b];
    const IVec3<I> w = pair.to_body[b].col(component);
    const IVec3<I> across = cross_product<I>(body.direction, k);
    out += dot<I>(body.point, cross_product<I>(w, k));
    for (int i = 0; i < 3; ++i) {
      if (is_exactly<I>(k[(i + 1) % 3], 0) && is_exactly<I>(k[(i + 2) % 3], 0)) continue;
      for (int j = 0; j < 3; ++j)
        if (!is_exactly<I>(w[j], 0)) out += across[i] * body.hessian(i, j) * w[j];
    }
  }
  return out;
}

template <class I>
I bending_of(const ChartedPair<I>& pair, const DirectionBox<I>& box, const Vec3<double>& c) {
  const IVec3<I> d = pair.columns * box.v, b = cross_product<I>(d, enclosed<I>(c));
  I out(0.0), height = -dot<I>(pair.pair.centre, IVec3<I>(pair.frame * box.v));
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyBox<I>& body = box.bodies[i];
    const IVec3<I> across = cross_product<I>(body.direction, IVec3<I>(pair.from_base[i] * enclosed<I>(c)));
    out += dot<I>(across, IVec3<I>(body.hessian * across));
    height += dot<I>(body.point, body.direction);
  }
  return out - height * squared_length<I>(b) / squared_length<I>(d);
}

template <class I>
bool is_within(const Mat3<double>& frame, const IVec3<I>& d, double half) {
  const LocalDirection<I> at = local_direction<I>(frame, d);
  const I edge = I(half) * at.w[2];
  return is_positive(at.determinant) && is_positive(at.w[2]) && low(I(edge - magnitude<I>(at.w[0]))) >= 0 &&
         low(I(edge - magnitude<I>(at.w[1]))) >= 0;
}

template <class I>
bool holds(const ChartedPair<I>& pair, const Cell& cell, const Exclusion& exclusion) {
  const Functional<I> phi =
      exclusion.axis < 0 ? functional<I>(pair, exclusion.c) : axis_functional<I>(pair, exclusion.axis);
  const DirectionBox<I> box = direction_box<I>(pair, box_of<I>(cell, cell.half));
  I value;
  if (exclusion.by_slopes) {
    const I reach = hull<I>(-cell.half, cell.half);
    value = value_of<I>(direction_box<I>(pair, box_of<I>(cell, 0)), phi);
    for (const int step : {1, 2}) value += slope_of<I>(pair, box, phi, (cell.axis + step) % 3) * reach;
  } else {
    value = value_of<I>(box, phi);
  }
  return has_no_zero<I>(value);
}

#define PLUMB_INSTANTIATE_DIRECTION_BOX(I)                                                       \
  template struct ChartedPair<I>;                                                                \
  template struct Functional<I>;                                                                 \
  template DirectionBox<I> direction_box(const ChartedPair<I>&, const IVec3<I>&);                \
  template Functional<I> functional(const ChartedPair<I>&, const Vec3<double>&);                 \
  template Functional<I> axis_functional(const ChartedPair<I>&, int);                            \
  template I value_of(const DirectionBox<I>&, const Functional<I>&);                             \
  template I slope_of(const ChartedPair<I>&, const DirectionBox<I>&, const Functional<I>&, int); \
  template I bending_of(const ChartedPair<I>&, const DirectionBox<I>&, const Vec3<double>&);     \
  template bool is_within(const Mat3<double>&, const IVec3<I>&, double);                         \
  template bool holds(const ChartedPair<I>&, const Cell&, const Exclusion&);

PLUMB_INSTANTIATE_DIRECTION_BOX(RoughInterval)
PLUMB_INSTANTIATE_DIRECTION_BOX(Interval18)
PLUMB_INSTANTIATE_DIRECTION_BOX(Interval80)

}  // namespace plumb::reference
