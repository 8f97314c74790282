// The body of verify.hpp, for whoever instantiates it: verify.cpp with MPFI's intervals, verify_double.cpp without.
#pragma once

#include <optional>

#include "solver/reference/proof/verify.hpp"

namespace plumb::reference {
namespace {

/// The leaf's corners as seen on the face of the region; nothing where one lies behind it.
template <class I>
std::optional<Reach> reach_of(const Cell& leaf, const Cell& region) {
  Reach out;
  for (const double du : {-1.0, 1.0})
    for (const double dv : {-1.0, 1.0}) {
      const Vec3<double> corner = leaf.at(du, dv);
      if (!(corner[region.axis] * region.sign > 0)) return {};
      const I along = I(corner[region.axis]) * I(region.sign);
      const I u = I(corner[(region.axis + 1) % 3]) / along, v = I(corner[(region.axis + 2) % 3]) / along;
      out.low_u = std::min(out.low_u, low(u));
      out.high_u = std::max(out.high_u, high(u));
      out.low_v = std::min(out.low_v, low(v));
      out.high_v = std::max(out.high_v, high(v));
    }
  return out;
}

/// Whether a part of a region's face lies in the region.
template <class I>
bool lies_in(const Reach& part, const Cell& region) {
  const auto between = [&](double from, double to, double middle) {
    return low(I(I(from) - I(middle))) >= -region.half && high(I(I(to) - I(middle))) <= region.half;
  };
  return between(part.low_u, part.high_u, region.u) && between(part.low_v, part.high_v, region.v);
}

void extend(Reach& whole, const Reach& part) {
  whole.low_u = std::min(whole.low_u, part.low_u);
  whole.high_u = std::max(whole.high_u, part.high_u);
  whole.low_v = std::min(whole.low_v, part.low_v);
  whole.high_v = std::max(whole.high_v, part.high_v);
}

/// w.v and |v|^2 at a corner of a cell.
template <class I>
struct Corner {
  I value, length2;
};

template <class I>
std::array<Corner<I>, 4> corners(const Cell& cell, const IVec3<I>& w) {
  const int first = (cell.axis + 1) % 3, second = (cell.axis + 2) % 3;
  const I along = cell.sign > 0 ? w[cell.axis] : I(-w[cell.axis]);
  std::array<Corner<I>, 4> out;
  for (std::size_t i = 0; i < 2; ++i) {
    const I u(cell.u + (i == 0 ? -cell.half : cell.half)), v(cell.v + (i == 0 ? -cell.half : cell.half));
    const I by_u = w[first] * u + along, by_v = w[second] * v, u2 = square<I>(u) + I(1.0), v2 = square<I>(v);
    for (std::size_t j = 0; j < 2; ++j) {
      Corner<I>&at_u = out[2 * i + j], &at_v = out[2 * j + i];
      at_u.value += by_u;
      at_u.length2 += u2;
      at_v.value += by_v;
      at_v.length2 += v2;
    }
  }
  return out;
}

template <class I, class W>
class CoverCheck {
 public:
  CoverCheck(const FramedPair<I>& pair, const EnclosedPair<W>& bodies, const Cover& cover, double level)
      : pair_(pair), bodies_(bodies), cover_(cover), level2_(square<I>(I(I(level) * pair.longest))),
        centre_(pair.frame.transpose() * pair.pair.centre) {}

  CoverProof run() {
    proof_.well_formed = proof_.excluded = is_positive(pair_.shortest);
    proof_.reach.resize(cover_.regions.size());
    for (int face = 0; face < 6 && proof_.well_formed; ++face) walk(face_of_cube(face));
    proof_.well_formed &= next_ == cover_.tree.size();
    return proof_;
  }

 private:
  void walk(const Cell& cell) {
    if (next_ == cover_.tree.size()) {
      proof_.well_formed = false;
      return;
    }
    switch (cover_.tree[next_++]) {
      case Leaf::split:
        for (int i = 0; i < 4 && proof_.well_formed; ++i) walk(cell.quarter(i));
        return;
      case Leaf::excluded: proof_.excluded &= is_above(cell, take_witness()); return;
      case Leaf::bounded: extend_reach(cell); [[fallthrough]];
      case Leaf::open: proof_.least_open = std::min(proof_.least_open, lower_bound(cell, take_witness())); return;
      case Leaf::convex: (void)check_region(cell); return;
    }
  }

  struct Place {
    std::size_t region;
    Reach part;
  };

  /// Where in its region the next leaf lies; nothing, and the proof fails, when it does not.
  std::optional<Place> check_region(const Cell& cell) {
    const bool there = next_region_ < cover_.regions_of.size();
    const int index = there ? cover_.regions_of[next_region_++] : -1;
    if (index < 0 || index >= static_cast<int>(cover_.regions.size())) {
      proof_.well_formed = false;
      return {};
    }
    const auto region = static_cast<std::size_t>(index);
    const std::optional<Reach> part = reach_of<I>(cell, cover_.regions[region]);
    if (part && lies_in<I>(*part, cover_.regions[region])) return Place{region, *part};
    proof_.excluded = false;
    return {};
  }

  void extend_reach(const Cell& cell) {
    if (const auto place = check_region(cell)) extend(proof_.reach[place->region], place->part);
  }

  /// w with o(F v) |F v| >= w.v, from a witness that is proved to lie in the bodies.
  IVec3<I> take_witness() {
    const auto k = static_cast<std::size_t>(proof_.witnesses++);
    if (k >= cover_.witnesses.size()) {
      proof_.well_formed = false;
      return enclosed<I>(Vec3<double>::Zero());
    }
    const auto& [p1, p2] = cover_.witnesses[k];
    proof_.well_formed &= is_inside<W>(bodies_.body1, p1) && is_inside<W>(bodies_.body2, p2);
    IVec3<I> w = -centre_;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        w[i] += pair_.to_body1(j, i) * I(p1[j]);
        w[i] -= pair_.to_body2(j, i) * I(p2[j]);
      }
    return w;
  }

  /// w.v - level |F v| is concave in v for level >= 0: it is above zero on the cell when it is at the four corners.
  [[nodiscard]] bool is_above(const Cell& cell, const IVec3<I>& w) const {
    for (const Corner<I>& corner : corners<I>(cell, w))
      if (!is_positive(corner.value) || !is_positive(I(square<I>(corner.value) - level2_ * corner.length2)))
        return false;
    return true;
  }

  /// Where w.v is positive w.v / |v| has its least value at a corner; elsewhere |v| is at least 1.
  [[nodiscard]] double lower_bound(const Cell& cell, const IVec3<I>& w) const {
    double quotient = std::numeric_limits<double>::infinity(), value = quotient;
    for (const Corner<I>& corner : corners<I>(cell, w)) {
      value = std::min(value, low(corner.value));
      quotient = std::min(quotient, low(I(corner.value / (pair_.longest * root<I>(corner.length2)))));
    }
    return value >= 0 ? quotient : low(I(I(value) / pair_.shortest));
  }

  const FramedPair<I>& pair_;
  const EnclosedPair<W>& bodies_;
  const Cover& cover_;
  const I level2_;         ///< of level |F v| / |v|, squared
  const IVec3<I> centre_;  ///< of body 2, in the frame
  CoverProof proof_;
  std::size_t next_ = 0, next_region_ = 0;
};

/// The two columns of a map that belong to the coordinates of a face's chart.
template <class I>
ChartMap<I> chart_columns(const IMat3<I>& map, int axis) {
  ChartMap<I> out;
  out << map.col((axis + 1) % 3), map.col((axis + 2) % 3);
  return out;
}

/// Lower bound of the smallest eigenvalue of a sum of rank-one terms: their determinant is the sum of
/// weight_i weight_j (a_i x a_j)^2, which has no cancellation.
template <class I>
I least_eigenvalue(const std::array<RankOne<I>, 7>& terms) {
  I determinant(0.0), trace(0.0);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!is_positive(terms[i].weight)) continue;
    const IVec2<I>& a = terms[i].vector;
    trace += terms[i].weight * (square<I>(a[0]) + square<I>(a[1]));
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const IVec2<I>& b = terms[j].vector;
      determinant += terms[i].weight * terms[j].weight * square<I>(I(a[0] * b[1] - a[1] * b[0]));
    }
  }
  const I d = low_end<I>(determinant), t = high_end<I>(trace);
  if (!is_positive(d)) return I(0.0);
  const I inside = square<I>(t) - I(4.0) * d;
  const I spread = is_positive(inside) ? root<I>(inside) : (high(inside) > 0 ? root<I>(high_end<I>(inside)) : I(0.0));
  return low_end<I>(I(I(2.0) * d / (t + high_end<I>(spread))));
}

/// Hess (c |F v|) = c (F'F - g g' / |F v|^2) / |F v| with g = F'F v, in the chart's two coordinates: at most `most` times the
/// identity less a rank-one term.
template <class I>
struct LengthHessian {
  I most;
  RankOne<I> less;

  LengthHessian(const FramedPair<I>& framed, const IVec3<I>& box, int axis, const I& c) {
    const I length = length_of<I>(box), least = framed.shortest * low_end<I>(length),
            greatest = framed.longest * high_end<I>(length);
    most = c * square<I>(framed.longest) / least;
    const IVec3<I> g = framed.gram * box;
    less = {low_end<I>(I(c / (greatest * square<I>(greatest)))), {g[(axis + 1) % 3], g[(axis + 2) % 3]}};
  }
};

/// Which of the sharp and the rough forms of the bodies' Hessians: the first that shows the curvature to be positive, or the best.
enum class Forms { first, best };

/// Lower bound of the least eigenvalue of Hess (s - c |F v|) over the box.
template <class I>
I least_curvature(const FramedPair<I>& framed, const IVec3<I>& box, int axis, const I& c, Forms forms) {
  const EnclosedBody<I>&body1 = framed.pair.body1, &body2 = framed.pair.body2;
  const IVec3<I> q1 = framed.to_q1 * box, q2 = framed.to_q2 * box;
  const ChartMap<I> map1 = chart_columns<I>(framed.to_q1, axis), map2 = chart_columns<I>(framed.to_q2, axis);
  const LengthHessian<I> length(framed, box, axis, c);
  I best = -length.most;
  const auto consider = [&](const HessianTerms<I>& a, const HessianTerms<I>& b) {
    if (forms == Forms::first && is_positive(best)) return;
    const I found = least_eigenvalue<I>({a[0], a[1], a[2], b[0], b[1], b[2], length.less}) - length.most;
    if (low(found) > low(best)) best = low_end<I>(found);
  };
  const HessianTerms<I> sharp1 = hessian_terms<I>(body1, q1, map1), sharp2 = hessian_terms<I>(body2, q2, map2);
  consider(sharp1, sharp2);
  if (forms == Forms::first && is_positive(best)) return best;
  const HessianTerms<I> rough1 = hessian_floor<I>(body1, q1, map1), rough2 = hessian_floor<I>(body2, q2, map2);
  consider(sharp1, rough2);
  consider(rough1, sharp2);
  consider(rough1, rough2);
  return best;
}

/// Upper bound of o on the region: s(v) = |F v| o(F v) is convex, so its highest value is at a corner.
template <class I>
I highest_overlap(const FramedPair<I>& framed, const Cell& region, const IVec3<I>& box) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const double du : {-1.0, 1.0})
    for (const double dv : {-1.0, 1.0}) {
      IVec3<I> v = enclosed<I>(region.at(0, 0));
      v[(region.axis + 1) % 3] += I(du) * I(region.half);
      v[(region.axis + 2) % 3] += I(dv) * I(region.half);
      const I s = support_value<I>(framed.pair.body1, IVec3<I>(framed.to_q1 * v)) +
                  support_value<I>(framed.pair.body2, IVec3<I>(framed.to_q2 * v)) -
                  dot<I>(framed.pair.centre, IVec3<I>(framed.frame * v));
      highest = std::max(highest, high(s));
    }
  return highest > 0 ? high_end<I>(I(I(highest) / (framed.shortest * low_end<I>(length_of<I>(box))))) : I(0.0);
}

}  // namespace

template <class I>
FramedPair<I>::FramedPair(const EnclosedPair<I>& enclosed_pair, const Mat3<double>& f) : pair(enclosed_pair) {
  for (int i = 0; i < 9; ++i) frame(i / 3, i % 3) = I(f(i / 3, i % 3));
  to_body1 = pair.body1.rotation.transpose() * frame;
  to_body2 = pair.body2.rotation.transpose() * frame;
  to_q1 = pair.body1.semi_axes.asDiagonal() * to_body1;
  to_q2 = pair.body2.semi_axes.asDiagonal() * to_body2;
  // |F'F - 1| by row sums bounds how far the squared singular values are from 1.
  gram = frame.transpose() * frame;
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    I sum(0.0);
    for (int j = 0; j < 3; ++j) sum += magnitude<I>(I(gram(i, j) - I(i == j ? 1.0 : 0.0)));
    if (!(high(sum) <= worst)) worst = high(sum) < 1 ? high(sum) : std::numeric_limits<double>::infinity();
  }
  longest = high_end<I>(root<I>(I(I(1.0) + I(worst))));
  shortest = worst < 1 ? low_end<I>(root<I>(I(I(1.0) - I(worst)))) : I(0.0);
}

template <class I, class W>
CoverProof verify_cover(const FramedPair<I>& pair, const EnclosedPair<W>& bodies, const Cover& cover, double level) {
  return CoverCheck<I, W>(pair, bodies, cover, level).run();
}

template <class I>
I overlap_at(const FramedPair<I>& framed, const IVec3<I>& chart) {
  const I reach1 = support_value<I>(framed.pair.body1, IVec3<I>(framed.to_q1 * chart)),
          reach2 = support_value<I>(framed.pair.body2, IVec3<I>(framed.to_q2 * chart));
  const IVec3<I> direction = framed.frame * chart;
  return (reach1 + reach2 - dot<I>(framed.pair.centre, direction)) / length_of<I>(direction);
}

// The Hessian of |F v| is positive, so that the highest o of the region may stand for that of any point in it.
template <class I>
I curvature_on(const FramedPair<I>& framed, const Cell& region) {
  const IVec3<I> box = box_of<I>(region, region.half);
  return least_curvature<I>(framed, box, region.axis, highest_overlap<I>(framed, region, box), Forms::first);
}

template <class I>
I highest_curvature_on(const FramedPair<I>& framed, const Cell& region) {
  const IVec3<I> box = box_of<I>(region, region.half);
  return least_curvature<I>(framed, box, region.axis, highest_overlap<I>(framed, region, box), Forms::best);
}

// d s = (p1 + p2' - c).F dv, p2' the point of body 2 at +n.
template <class I>
OverlapAt<I> support_at(const FramedPair<I>& framed, const IVec3<I>& chart) {
  const EnclosedPair<I>& pair = framed.pair;
  const SupportEnclosure<I> h1 = support<I>(pair.body1, IVec3<I>(framed.to_q1 * chart)),
                            h2 = support<I>(pair.body2, IVec3<I>(framed.to_q2 * chart));
  const IVec3<I> direction = framed.frame * chart;
  const I length = length_of<I>(direction);
  return {(h1.value + h2.value - dot<I>(pair.centre, direction)) / length, direction, length,
          pair.body1.rotation * h1.point + pair.body2.rotation * h2.point - pair.centre};
}

template <class I>
Slope<I> slope_at(const FramedPair<I>& framed, int axis, const IVec3<I>& chart) {
  const OverlapAt<I> at = support_at<I>(framed, chart);
  I gradient2(0.0);
  for (const int step : {1, 2}) gradient2 += square<I>(at.slope(framed.frame.col((axis + step) % 3)));
  return {at.value, high_end<I>(root<I>(gradient2))};
}

// On the region s - o0 |F v| (o0 = o at the solution) is zero at the solution and, where its Hessian is at least
// mu > 0, convex.
template <class I>
RegionProof<I> proof_on(const Cell& region, const I& curvature, const IVec3<I>& chart, const Slope<I>& slope,
                        const I& shortest) {
  RegionProof<I> proof;
  proof.value = slope.value;
  proof.gradient = slope.gradient;
  proof.curvature = curvature;
  if (!is_positive(curvature)) return proof;
  proof.radius = high_end<I>(I(I(2.0) * slope.gradient / curvature));
  proof.deficit = high_end<I>(I(square<I>(slope.gradient) / (I(2.0) * curvature * shortest)));
  proof.convex = proof.located = true;
  for (const int step : {1, 2}) {
    const int i = (region.axis + step) % 3;
    const I off = magnitude<I>(I(chart[i] - I(region.at(0, 0)[i]))) + proof.radius;
    proof.located &= high(off) < region.half;
  }
  return proof;
}

template <class I>
RegionProof<I> verify_region(const FramedPair<I>& framed, const Cell& region, const IVec3<I>& chart) {
  return proof_on<I>(region, curvature_on<I>(framed, region), chart, slope_at<I>(framed, region.axis, chart),
                     framed.shortest);
}

template <class I>
std::optional<IVec3<I>> points_apart(const EnclosedPair<I>& pair, const Witness& witness) {
  if (!is_inside<I>(pair.body1, witness.point1) || !is_inside<I>(pair.body2, witness.point2)) return {};
  return IVec3<I>(pair.body1.rotation * enclosed<I>(witness.point1) - pair.centre -
                  pair.body2.rotation * enclosed<I>(witness.point2));
}

template <class I>
std::optional<I> least_overlap_apart(const EnclosedPair<I>& pair, const Witness& witness) {
  const auto apart = points_apart<I>(pair, witness);
  return apart ? std::optional<I>(-high_end<I>(length_of<I>(*apart))) : std::nullopt;
}

template <class I>
DirectionEnclosure<I> enclose_direction(const FramedPair<I>& framed, const IVec3<I>& box) {
  const IVec3<I> direction = framed.frame * box;
  const auto point_at = [&](const EnclosedBody<I>& body, const IMat3<I>& to_q) -> IVec3<I> {
    return body.rotation * support<I>(body, IVec3<I>(to_q * box)).point;
  };
  return {direction / length_of<I>(direction), point_at(framed.pair.body1, framed.to_q1),
          framed.pair.centre - point_at(framed.pair.body2, framed.to_q2)};
}

// NOLINTBEGIN(bugprone-macro-parentheses): the name of a type takes none
#define PLUMB_INSTANTIATE_VERIFY(I)                                                                     \
  template struct FramedPair<I>;                                                                        \
  template CoverProof verify_cover(const FramedPair<I>&, const EnclosedPair<I>&, const Cover&, double); \
  template I overlap_at(const FramedPair<I>&, const IVec3<I>&);                                         \
  template I curvature_on(const FramedPair<I>&, const Cell&);                                           \
  template I highest_curvature_on(const FramedPair<I>&, const Cell&);                                   \
  template OverlapAt<I> support_at(const FramedPair<I>&, const IVec3<I>&);                              \
  template Slope<I> slope_at(const FramedPair<I>&, int, const IVec3<I>&);                               \
  template RegionProof<I> proof_on(const Cell&, const I&, const IVec3<I>&, const Slope<I>&, const I&);  \
  template RegionProof<I> verify_region(const FramedPair<I>&, const Cell&, const IVec3<I>&);            \
  template std::optional<I> least_overlap_apart(const EnclosedPair<I>&, const Witness&);                \
  template DirectionEnclosure<I> enclose_direction(const FramedPair<I>&, const IVec3<I>&);              \
  template std::optional<IVec3<I>> points_apart(const EnclosedPair<I>&, const Witness&);
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace plumb::reference
