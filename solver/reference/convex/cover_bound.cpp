#include "solver/reference/convex/cover_bound.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "solver/reference/convex/proved.hpp"
#include "solver/reference/frame.hpp"

namespace plumb::reference::cores {
namespace {

constexpr int faces = 6;
constexpr double least_half = 0x1p-40;  // corners of cells are exact doubles down to 2^-50

struct Node {
  Cell cell;
  Mixture mixture;
};

class CoverSearch {
 public:
  CoverSearch(const PlacedCores& pair, LowDirection& lowest, int cells)
      : pair_(pair), frame_(frame_about(lowest.n)), lowest_(lowest), level_(lowest.overlap), cells_(cells) {}

  CoverBound run() {
    if (cells_ < faces || !is_proved_regular(frame_)) return {-infinity, 0};
    for (int face = 0; face < faces; ++face) add(face_of_cube(face), {});
    while (!queue_.empty() && static_cast<int>(nodes_.size()) + 4 <= cells_ && -queue_.top().first < target())
      split_or_leave();
    for (; !queue_.empty(); queue_.pop()) leave(queue_.top().second);
    return {lower_, static_cast<int>(nodes_.size())};
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

  void split_or_leave() {
    const int index = queue_.top().second;
    queue_.pop();
    const Node node = nodes_[static_cast<std::size_t>(index)];
    if (node.cell.half < least_half) return leave(index);
    for (int k = 0; k < 4; ++k) add(node.cell.quarter(k), node.mixture.atoms);
  }

  /// The leaf stays as it is.
  void leave(int index) {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    lower_ = std::min(lower_, proved_in(pair_, node.mixture, frame_, node.cell));
  }

  const PlacedCores& pair_;
  const Mat3<double> frame_;
  LowDirection& lowest_;
  double level_;
  const int cells_;
  double lower_ = infinity;
  std::vector<Node> nodes_;
  std::priority_queue<std::pair<double, int>> queue_;  // of the leaves; highest -value first
};

}  // namespace

CoverBound bound_by_cover(const PlacedCores& pair, LowDirection& lowest, int cells) {
  return CoverSearch(pair, lowest, cells).run();
}

}  // namespace plumb::reference::cores
