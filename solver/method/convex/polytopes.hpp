// The lowest overlap along the face normals and edges of two polytopes: where they overlap it is the lowest of all.
//
// o is linear between them: a minimum lies on the normal of a face of one body, or where the normals of an edge of one cross those of an
// edge of the other, that is along the product of the edges. Edges whose normals lie on one side of the other edge do not cross; where
// rounding hides a sign, the crossing is at one of these normals to rounding. What is left is not asked on which side it crosses: normals
// of a thin plate are opposite to rounding. So no tolerance decides which face or edge it is.
//
// Most are left out by points w of M: o(n) >= w.n, and where that is above an overlap that is known on both sides of an edge it is so all
// along it.
#pragma once

#include <utility>

#include "solver/method/convex/edges.hpp"

namespace plumb::detail {

class PolytopeMinimum {
 public:
  /// `known`: a unit direction whose overlap is low already, and above 0.
  PolytopeMinimum(const PlacedCores& pair, const Vec3<double>& known)
      : pair_(pair), best_(pair.overlap(known) * (1 + margin)) {
    if (!pair.has_hull()) return;  // few faces and edges: all are looked at
    const Vec3<double> s = known.unitOrthogonal(), t = known.cross(s);
    for (; witness_count_ < witnesses_.size(); ++witness_count_) {
      const std::size_t k = witness_count_;
      const double aside = k % 2 == 0 ? wide : narrow;
      witnesses_[k] = pair.support((known + aside * (eighths[k + 2] * s + eighths[k] * t)).normalized()).w();
    }
  }

  /// nullopt: a body is no polytope, or no face and no crossing of edges is as low as what is known.
  [[nodiscard]] std::optional<Vec3<double>> lowest() {
    const bool are_polytopes = with_edges(pair_.body1.core, [&](const auto& first) {
      (void)with_edges(pair_.body2.core, [&](const auto& second) { look_at(first, second); });
    });
    return are_polytopes ? normal_ : std::nullopt;
  }

  /// The lowest of the face normals alone, where it is as low to rounding: where an edge lies along a face, their product is rounding.
  [[nodiscard]] std::optional<Vec3<double>> face_as_low() const {
    return best_face_ <= best_ + pair_.rounding() ? face_ : std::nullopt;
  }

 private:
  static constexpr int together = 12;
  static constexpr double wide = 2, narrow = 0.5;
  static constexpr std::array<double, 10> eighths{0,    0.7, 1,    0.7, 0,
                                                  -0.7, -1,  -0.7, 0,   0.7};  // about the sine of k turns
  static constexpr double margin = 1e-9;  // a normal that is known may be that of a face, to rounding

  /// o(n).
  double consider(const Vec3<double>& n) {
    const double overlap = pair_.overlap(n);
    if (overlap < best_) best_ = overlap, normal_ = n;
    return overlap;
  }

  /// Whether a witness is higher than the lowest that is known, along both.
  [[nodiscard]] bool is_left_out(const Vec3<double>& n1, const Vec3<double>& n2) const {
    return std::any_of(witnesses_.begin(), witnesses_.begin() + static_cast<std::ptrdiff_t>(witness_count_),
                       [&](const Vec3<double>& w) { return w.dot(n1) > best_ && w.dot(n2) > best_; });
  }

  template <class First, class Second>
  void look_at(const First& first, const Second& second) {
    const Mat3<double>&r1 = pair_.body1.rotation, &r2 = pair_.body2.rotation;
    const auto consider_unless_high = [&](const Vec3<double>& n) {
      if (is_left_out(n, n)) return;
      if (const double overlap = consider(n); overlap < best_face_) best_face_ = overlap, face_ = n;
    };
    for (int k = 0; k < first.faces(); ++k) consider_unless_high(r1 * first.face_normal(k));
    for (int k = 0; k < second.faces(); ++k) consider_unless_high(-(r2 * second.face_normal(k)));
    look_at_crossings(first, second);
  }

  /// Each two directions of edges cross somewhere, on one side or the other.
  template <HasDirections First, HasDirections Second>
  void look_at_crossings(const First& first, const Second& second) {
    for (int i = 0; i < first.directions(); ++i)
      for (int j = 0; j < second.directions(); ++j) {
        const Vec3<double> product =
            crossing_of(pair_.body1.rotation * first.direction(i), pair_.body2.rotation * second.direction(j));
        if (!(product.squaredNorm() > 0)) continue;
        const Vec3<double> n = product.normalized();
        consider(n.dot(pair_.body2.centre) < 0 ? (-n).eval() : n);  // o is as high along both, but for the centres
      }
  }

  template <class First, class Second>
  void look_at_crossings(const First& first, const Second& second) {
    std::array<EdgeOfCore, together> against;
    int count = 0;
    for (int j = 0; j < second.edges(); ++j) {
      const EdgeOfCore edge = placed(pair_.body2, second.edge(j), -1);
      if (edge.has_faces && is_left_out(edge.normals[0], edge.normals[1])) continue;
      against[static_cast<std::size_t>(count++)] = edge;
      if (count == together) look_at_edges(first, against, std::exchange(count, 0));
    }
    look_at_edges(first, against, count);
  }

  template <class First>
  void look_at_edges(const First& first, const std::array<EdgeOfCore, together>& against, int count) {
    for (int i = 0; i < first.edges() && count > 0; ++i) {
      const EdgeOfCore edge = placed(pair_.body1, first.edge(i), 1);
      if (edge.has_faces && is_left_out(edge.normals[0], edge.normals[1])) continue;
      for (int j = 0; j < count; ++j) look_at_edges(edge, against[static_cast<std::size_t>(j)]);
    }
  }

  void look_at_edges(const EdgeOfCore& a, const EdgeOfCore& b) {
    const Vec3<double> along = a.direction(), other = b.direction();
    if (!is_crossed_by(a, other) || !is_crossed_by(b, along)) return;
    const Vec3<double> product = crossing_of(along, other);
    if (!(product.squaredNorm() > 0)) return;
    const Vec3<double> n = product.normalized();
    for (const double sign : {1.0, -1.0})  // the arcs cross at one of the two; along the other o is no lower than it is
      if (sign * n.dot(a.from - b.from) < best_) consider(sign * n);
  }

  /// Whether the plane across `direction` goes between the edge's two normals, or through one.
  [[nodiscard]] static bool is_crossed_by(const EdgeOfCore& edge, const Vec3<double>& direction) {
    return !edge.has_faces || edge.normals[0].dot(direction) * edge.normals[1].dot(direction) <= 0;
  }

  const PlacedCores& pair_;
  double best_, best_face_ = std::numeric_limits<double>::infinity();
  std::optional<Vec3<double>> normal_, face_;
  std::array<Vec3<double>, 8> witnesses_;
  std::size_t witness_count_ = 0;
};

}  // namespace plumb::detail
