// The lens as its radial function about a point inside: any overlap, however deep, a body inside the other too.
//
// A direction is A d, A the frame's axes, d on the unit sphere in spherical coordinates about e3; a ray meets the nearer of the two
// surfaces at r(d). With dw = cos(latitude) dlatitude dazimuth the volume behind dw is det(A) r^3 dw / 3, and y . dA = det(A) r^3 dw.
// Meridians are cut into panels, and a panel where they pass from one body's surface to the other's once more, there. Gauss on
// each piece, the trapezoidal rule over the azimuth.
#pragma once

#include "solver/patch/gauss_rule.hpp"
#include "solver/patch/lens_moments.hpp"

namespace plumb::detail {

class Meridians {
 public:
  Meridians(const Lens& lens, const LensFrame& frame, double accuracy)
      : lens_(lens), frame_(frame), accuracy_(accuracy), determinant_(std::abs(frame.axes.determinant())) {}

  /// Adds the half-circle at an azimuth, cut into so many panels; `share`: of the circle.
  void add(LensMoments& sum, double azimuth, double share, int panels) const {
    const Ray ray{frame_.across(azimuth), frame_.axes.col(2)};
    const double width = std::numbers::pi / panels;
    double low = -std::numbers::pi / 2;
    std::size_t owner = exit(ray, low).owner;
    for (int k = 1; k <= panels; ++k) {
      const double high = k * width - std::numbers::pi / 2;
      const std::size_t next = exit(ray, high).owner;
      if (next != owner) {
        const double middle = crossing(ray, low, high, owner);
        add_panel(sum, ray, low, middle, share);
        low = middle;
      }
      add_panel(sum, ray, low, high, share);
      low = high, owner = next;
    }
  }

 private:
  struct Ray {
    Vec3<double> across, up;

    [[nodiscard]] Vec3<double> at(double latitude) const {
      return std::cos(latitude) * across + std::sin(latitude) * up;
    }
  };

  struct Exit {
    double t;
    Vec3<double> gradient;
    std::size_t owner;
  };
  [[nodiscard]] Exit exit(const Ray& ray, double latitude) const {
    const auto both = lens_.exits(frame_.origin, ray.at(latitude), accuracy_);
    const std::size_t owner = both[0].t <= both[1].t ? 0 : 1;
    return {both[owner].t, both[owner].gradient, owner};
  }
  /// Where the surface is no longer that of `owner`, by halving.
  [[nodiscard]] double crossing(const Ray& ray, double low, double high, std::size_t owner) const {
    const double fine = std::max(accuracy_ * accuracy_, 4 * epsilon<double>());
    while (high - low > fine) {
      const double middle = (low + high) / 2;
      (exit(ray, middle).owner == owner ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  void add_panel(LensMoments& sum, const Ray& ray, double low, double high, double share) const {
    static constexpr std::size_t points = 4;
    static constexpr GaussRule<points> rule = gauss_rule<points, 0>();
    for (std::size_t i = 0; i < points; ++i) {
      const double latitude = low + rule.nodes[i] * (high - low);
      const Exit at = exit(ray, latitude);
      const Vec3<double> y = at.t * ray.at(latitude);
      const double height =
          determinant_ * at.t * at.t * at.t * std::cos(latitude) * rule.weights[i] * (high - low) * share;
      sum.add_cone(frame_.coordinates(y), height);
      sum.add_area(y, height / at.gradient.dot(y) * at.gradient, at.owner);
    }
  }

  const Lens& lens_;
  const LensFrame& frame_;
  double accuracy_, determinant_;
};

}  // namespace plumb::detail
