#include "solver/reference/convex/cover_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "solver/reference/frame.hpp"

namespace plumb::reference::cores {
namespace {

constexpr std::array<std::array<double, 2>, 4> corner_places{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

/// A box that holds sum of weights times points of A, and the sum of the weights.
struct ProvedMixture {
  IVec3<I> w{I(0.0), I(0.0), I(0.0)};
  I sum{0.0};

  ProvedMixture(const PlacedCores& pair, const Mixture& mixture) {
    for (std::size_t i = 0; i < mixture.atoms.size(); ++i) {
      const IVec3<I> point = pair.proved(mixture.atoms[i]);
      const I weight(mixture.weights[i]);
      for (int k = 0; k < 3; ++k) w[k] += weight * point[k];
      sum += weight;
    }
  }
  [[nodiscard]] double everywhere() const { return low(I(-(length_of<I>(w) / sum))); }
};

IVec3<I> enclosed_corner(const Mat3<double>& frame, const Vec3<double>& at) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i)
    out[i] = I(frame(i, 0)) * I(at[0]) + I(frame(i, 1)) * I(at[1]) + I(frame(i, 2)) * I(at[2]);
  return out;
}

/// Whether directions F v are all directions.
bool is_proved_regular(const Mat3<double>& frame) {
  const IVec3<I> x = enclosed<I>(Vec3<double>(frame.col(0))), y = enclosed<I>(Vec3<double>(frame.col(1))),
                 z = enclosed<I>(Vec3<double>(frame.col(2)));
  return is_positive(dot<I>(x, cross_product<I>(y, z)));
}

struct Node {
  Cell cell;
  Mixture mixture;
};

class CoverSearch {
 public:
  CoverSearch(const PlacedCores& pair, LowDirection& lowest, int cells)
      : pair_(pair), frame_(frame_about(lowest.n)), lowest_(lowest), level_(lowest.overlap), cells_(cells) {}

  CoverBound run() {
    for (int face = 0; face < 6; ++face) add(face_of_cube(face), {});
    while (static_cast<int>(nodes_.size()) + 4 <= cells_ && -queue_.top().first < target()) split();
    return {is_proved_regular(frame_) ? proved() : -std::numeric_limits<double>::infinity(),
            static_cast<int>(nodes_.size())};
  }

 private:
  [[nodiscard]] double target() const { return level_ - worthwhile_gap; }

  void add(const Cell& cell, std::vector<Atom> start) {
    CornersOfCell corners;
    for (std::size_t j = 0; j < 4; ++j)
      corners[j] = (frame_ * cell.at(corner_places[j][0], corner_places[j][1])).normalized();
    Mixture mixture = mixture_in(pair_, corners, std::move(start), {target(), level_}, lowest_);
    queue_.emplace(-mixture.value, static_cast<int>(nodes_.size()));
    nodes_.push_back({cell, std::move(mixture)});
    if (lowest_.overlap < target()) sink();
  }

  /// A lower direction was met.
  void sink() {
    const LowDirection found = descend(pair_, lowest_.n).lowest;
    if (found.overlap < lowest_.overlap) lowest_ = found;
    level_ = lowest_.overlap;
  }

  void split() {
    const Node node = std::move(nodes_[static_cast<std::size_t>(queue_.top().second)]);
    queue_.pop();
    for (int k = 0; k < 4; ++k) add(node.cell.quarter(k), node.mixture.atoms);
  }

  [[nodiscard]] double proved() {
    double out = std::numeric_limits<double>::infinity();
    for (; !queue_.empty(); queue_.pop()) {
      const Node& node = nodes_[static_cast<std::size_t>(queue_.top().second)];
      out = std::min(out, proved_in(pair_, node.mixture, frame_, node.cell));
    }
    return out;
  }

  const PlacedCores& pair_;
  const Mat3<double> frame_;
  LowDirection& lowest_;
  double level_;
  const int cells_;
  std::vector<Node> nodes_;
  std::priority_queue<std::pair<double, int>> queue_;  // of the leaves; highest -value first
};

}  // namespace

double proved_in(const PlacedCores& pair, const Mixture& mixture, const Mat3<double>& frame, const Cell& cell) {
  const ProvedMixture proved(pair, mixture);
  double out = std::numeric_limits<double>::infinity();
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

CoverBound bound_by_cover(const PlacedCores& pair, LowDirection& lowest, int cells) {
  return CoverSearch(pair, lowest, cells).run();
}

}  // namespace plumb::reference::cores
