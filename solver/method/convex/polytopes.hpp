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

#include <cstdint>
#include <utility>

#include "solver/method/convex/edges.hpp"

namespace plumb::detail {

class PolytopeMinimum {
 public:
  /// `known`: a unit direction whose overlap is low already.
  PolytopeMinimum(const PlacedCores& pair, const Vec3<double>& known)
      : pair_(pair), best_(a_little_above(pair.overlap(known))), has_witnesses_(pair.has_hull()) {
    if (!has_witnesses_) return;
    const Vec3<double> s = known.unitOrthogonal(), t = known.cross(s);
    for (int k = 0; k < most_witnesses; ++k) {
      const double aside = k % 2 == 0 ? wide : narrow;
      const auto at = static_cast<std::size_t>(k);
      witnesses_.row(k) = pair.support((known + aside * (eighths[at + 2] * s + eighths[at] * t)).normalized()).w();
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
  static constexpr int most_witnesses = 8;
  static constexpr double wide = 2, narrow = 0.5;
  static constexpr std::array<double, 10> eighths{0,    0.7, 1,    0.7, 0,
                                                  -0.7, -1,  -0.7, 0,   0.7};  // about the sine of k turns
  /// A normal that is known may be that of a face, to rounding.
  [[nodiscard]] double a_little_above(double overlap) const {
    constexpr double margin = 1e-9;
    return overlap + std::max(margin * std::abs(overlap), pair_.rounding());
  }

  /// o(n).
  double consider(const Vec3<double>& n) {
    const double overlap = pair_.overlap(n);
    if (overlap < best_) best_ = overlap, normal_ = n;
    return overlap;
  }

  using Witnesses = Eigen::Matrix<double, most_witnesses, 3>;  // a row each
  /// Of each of a body's faces the witnesses that were higher than the lowest that was known, a bit each. Of faces beyond the last place it is
  /// found when it is asked for.
  struct Higher {
    Witnesses turned;  ///< into the body's axes, and to its side
    std::array<std::uint8_t, 512> of_face;
  };

  [[nodiscard]] static unsigned bits_above(const Eigen::Matrix<double, most_witnesses, 1>& heights, double level) {
    unsigned out = 0;
    for (int k = 0; k < most_witnesses; ++k) out |= (heights[k] > level ? 1U : 0U) << k;
    return out;
  }

  template <class Edges>
  [[nodiscard]] unsigned higher_along(const Edges& edges, const Higher& higher, int face) const {
    if (static_cast<std::size_t>(face) < higher.of_face.size()) return higher.of_face[static_cast<std::size_t>(face)];
    return bits_above(higher.turned.lazyProduct(Vec3<double>(edges.face_normal(face))), best_);
  }
  /// Whether one witness is higher along the normals of both faces, and so along all between them.
  template <class Edges>
  [[nodiscard]] bool is_left_out(const Edges& edges, const Higher& higher, int edge) const {
    const auto [first, second] = edges.sides(edge);
    return has_witnesses_ && first >= 0 &&
           (higher_along(edges, higher, first) & higher_along(edges, higher, second)) != 0;
  }

  template <class First, class Second>
  void look_at(const First& first, const Second& second) {
    const Higher higher1 = look_at_faces(first, pair_.body1.rotation, 1),
                 higher2 = look_at_faces(second, pair_.body2.rotation, -1);
    look_at_crossings(first, higher1, second, higher2);
  }

  template <class Edges>
  [[nodiscard]] Higher look_at_faces(const Edges& edges, const Mat3<double>& rotation, double sign) {
    Higher out;
    if (has_witnesses_) out.turned = sign * witnesses_ * rotation;
    for (int face = 0; face < edges.faces(); ++face) {
      const Vec3<double>& n = edges.face_normal(face);
      const unsigned higher = has_witnesses_ ? bits_above(out.turned.lazyProduct(n), best_) : 0;
      if (static_cast<std::size_t>(face) < out.of_face.size())
        out.of_face[static_cast<std::size_t>(face)] = static_cast<std::uint8_t>(higher);
      if (higher != 0) continue;
      const Vec3<double> in_frame = sign * (rotation * n);
      if (const double overlap = consider(in_frame); overlap < best_face_) best_face_ = overlap, face_ = in_frame;
    }
    return out;
  }

  /// Each two directions of edges cross somewhere, on one side or the other.
  template <HasDirections First, HasDirections Second>
  void look_at_crossings(const First& first, const Higher& /*unused*/, const Second& second, const Higher& /*unused*/) {
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
  void look_at_crossings(const First& first, const Higher& higher1, const Second& second, const Higher& higher2) {
    std::array<EdgeOfCore, together> against;
    int count = 0;
    for (int j = 0; j < second.edges(); ++j) {
      if (is_left_out(second, higher2, j)) continue;
      against[static_cast<std::size_t>(count++)] = placed(pair_.body2, second.edge(j), -1);
      if (count == together) look_at_edges(first, higher1, against, std::exchange(count, 0));
    }
    look_at_edges(first, higher1, against, count);
  }

  template <class First>
  void look_at_edges(const First& first, const Higher& higher, const std::array<EdgeOfCore, together>& against,
                     int count) {
    for (int i = 0; i < first.edges() && count > 0; ++i) {
      if (is_left_out(first, higher, i)) continue;
      const EdgeOfCore edge = placed(pair_.body1, first.edge(i), 1);
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
  bool has_witnesses_;  ///< few faces and edges are all looked at
  Witnesses witnesses_;
};

}  // namespace plumb::detail
