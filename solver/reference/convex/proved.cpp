#include "solver/reference/convex/proved.hpp"

#include <algorithm>

namespace plumb::reference::cores {
namespace {

/// A box that holds sum of weights times points of A, and the sum of the weights.
struct ProvedMixture {
  IVec3<I> w{I(0.0), I(0.0), I(0.0)};
  I sum{0.0};

  ProvedMixture(const PlacedCores& pair, const Mixture& mixture) {
    for (std::size_t i = 0; i < mixture.atoms.size(); ++i) {
      if (!(mixture.weights[i] >= 0)) continue;
      const IVec3<I> point = pair.proved(mixture.atoms[i]);
      const I weight(mixture.weights[i]);
      for (int k = 0; k < 3; ++k) w[k] += weight * point[k];
      sum += weight;
    }
  }
  [[nodiscard]] bool is_any() const { return is_positive(sum); }
  [[nodiscard]] double everywhere() const { return is_any() ? low(I(-(length_of<I>(w) / sum))) : -infinity; }
};

IVec3<I> enclosed_corner(const Mat3<double>& frame, const Vec3<double>& at) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i)
    out[i] = I(frame(i, 0)) * I(at[0]) + I(frame(i, 1)) * I(at[1]) + I(frame(i, 2)) * I(at[2]);
  return out;
}

}  // namespace

double proved_in(const PlacedCores& pair, const Mixture& mixture, const Mat3<double>& frame, const Cell& cell) {
  const ProvedMixture proved(pair, mixture);
  double out = infinity;
  for (const auto& [du, dv] : corner_places) {
    const IVec3<I> corner = enclosed_corner(frame, cell.at(du, dv));
    const double reach = low(I(dot<I>(proved.w, corner) / (proved.sum * length_of<I>(corner))));
    if (!(reach >= 0)) return proved.everywhere();
    out = std::min(out, reach);
  }
  return out;
}

double proved_everywhere(const PlacedCores& pair, const Mixture& mixture) {
  return ProvedMixture(pair, mixture).everywhere();
}

bool is_proved_regular(const Mat3<double>& frame) {
  const IVec3<I> x = enclosed<I>(Vec3<double>(frame.col(0))), y = enclosed<I>(Vec3<double>(frame.col(1))),
                 z = enclosed<I>(Vec3<double>(frame.col(2)));
  return is_positive(dot<I>(x, cross_product<I>(y, z)));
}

}  // namespace plumb::reference::cores
