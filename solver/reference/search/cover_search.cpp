#include "solver/reference/search/cover_search.hpp"

#include <algorithm>
#include <queue>

#include "solver/reference/meter.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reference {
namespace {

constexpr double inside = 1 - 16 * machine_epsilon;  // witnesses are drawn in by this, to lie in their bodies for sure
constexpr double above = 128 * machine_epsilon;      // how far above the level a corner must be to be so in intervals
constexpr double small_cell = 1.0 / (1 << 10);       // of this half-width a cell is worth a question
constexpr double tiny_cell = 1.0 / (1LL << 44);      // smaller cells have no exact corners

struct Node {
  Cell cell;
  Leaf leaf = Leaf::open;
  double bound = 0;  ///< no direction of the cell has a lower overlap
  Witness witness{};
  int children = -1;  ///< first of four
  int region = -1;
};

Vec3<double> drawn_in(const Superellipsoid<double>& shape, const Vec3<double>& surface_point) {
  return surface_point * (inside / gauge<double>(shape, surface_point));
}

Vec3<double> witness_point(const Superellipsoid<double>& shape, const Vec3<double>& u) {
  return drawn_in(shape, support_point<double>(shape, u).gradient);
}

bool lies_in(const Cell& leaf, const Cell& region) {
  const double reach = region.half * (1 - 4 * machine_epsilon);
  for (const double du : {-1.0, 1.0})
    for (const double dv : {-1.0, 1.0}) {
      const Vec3<double> corner = leaf.at(du, dv);
      const double along = corner[region.axis] * region.sign;
      if (!(along > 0)) return false;
      if (std::abs(corner[(region.axis + 1) % 3] / along - region.u) > reach) return false;
      if (std::abs(corner[(region.axis + 2) % 3] / along - region.v) > reach) return false;
    }
  return true;
}

class CoverSearch {
 public:
  CoverSearch(const PlacedPair<double>& pair, const Mat3<double>& frame, double level,
              const std::vector<KnownMinimum>& minima, const CoverLimits& limits, const Settle& settle)
      : pair_(pair), level_(level), limits_(limits), settle_(settle), frame_(frame),
        to_body1_(pair.body1.rotation.transpose() * frame), to_body2_(pair.body2.rotation.transpose() * frame),
        centre_(frame.transpose() * pair.body2.centre) {
    result_.cover.frame = frame;
    for (const KnownMinimum& minimum : minima) know(minimum);
  }

  CoverResult run() {
    for (int face = 0; face < 6; ++face) (void)add(face_of_cube(face));
    while (!queue_.empty() && !result_.done && static_cast<int>(nodes_.size()) < limits_.cells) {
      const int i = queue_.top().second;
      queue_.pop();
      settle_or_split(i);
    }
    result_.cells = static_cast<int>(nodes_.size());
    result_.exhausted = !queue_.empty();
    if (result_.done) return std::move(result_);
    for (int face = 0; face < 6; ++face) write(face);
    std::stable_sort(open_.begin(), open_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [bound, direction] : open_) result_.open.push_back(direction);
    return std::move(result_);
  }

 private:
  int add(const Cell& cell) {
    count_work(nanoseconds_of_a_node);
    Node node{cell};
    const Vec3<double> v = cell.at(0, 0);
    node.witness = {witness_point(pair_.body1.shape, to_body1_ * v),
                    witness_point(pair_.body2.shape, -(to_body2_ * v))};
    const Vec3<double> w = apart(node.witness);
    if (w.dot(v) / v.norm() < level_ - above) learn(settle_((frame_ * v).normalized()));
    const int index = static_cast<int>(nodes_.size());
    if (bound(node, w))
      node.leaf = Leaf::excluded;
    else if (!is_settled(node))
      queue_.emplace(-node.bound, index);
    nodes_.push_back(node);
    return index;
  }

  /// w with o(F v) |F v| >= w.v, in the frame.
  [[nodiscard]] Vec3<double> apart(const Witness& witness) const {
    return to_body1_.transpose() * witness.point1 - to_body2_.transpose() * witness.point2 - centre_;
  }

  void learn(const Settled& settled) {
    level_ = std::min(level_, settled.level);
    result_.done = result_.done || settled.done;
    if (settled.minimum) know(*settled.minimum);
  }

  void know(const KnownMinimum& minimum) {
    minima_.push_back(minimum);
    result_.cover.regions.push_back(minimum.region);
  }

  /// Sets the bound; whether the whole cell is above the level.
  bool bound(Node& node, const Vec3<double>& w) const {
    double quotient = std::numeric_limits<double>::infinity(), value = quotient, margin = quotient;
    for (const double du : {-1.0, 1.0})
      for (const double dv : {-1.0, 1.0}) {
        const Vec3<double> corner = node.cell.at(du, dv);
        const double at = w.dot(corner), length = corner.norm();
        value = std::min(value, at);
        quotient = std::min(quotient, at / length);
        margin = std::min(margin, at - level_ * length);
      }
    node.bound = value >= 0 ? quotient : value;
    return (level_ >= 0 ? margin : node.bound - level_) > above;
  }

  /// Whether the cell lies in a region and nothing more needs to be known about it.
  bool is_settled(Node& node) {
    for (std::size_t k = 0; k < minima_.size(); ++k) {
      if (!lies_in(node.cell, minima_[k].region)) continue;
      node.region = static_cast<int>(k);
      node.leaf = minima_[k].tight ? Leaf::convex : Leaf::bounded;
      if (!minima_[k].tight) bound_by(node, minima_[k].points);
      return minima_[k].tight || node.bound > level_ - limits_.gap;
    }
    return false;
  }

  /// Takes the minimum's own points for witness where they bound the cell better than those at its centre.
  void bound_by(Node& node, const Witness& points) const {
    const double before = node.bound;
    (void)bound(node, apart(points));
    if (node.bound > before)
      node.witness = points;
    else
      node.bound = before;
  }

  /// Near a known solution outside any region its points bound o by the cosine of the angle.
  void bound_by_points(Node& node) const {
    if (node.region >= 0 || node.cell.half > small_cell) return;
    for (const KnownMinimum& minimum : minima_) bound_by(node, minimum.points);
  }

  void settle_or_split(int i) {
    Node& node = nodes_[static_cast<std::size_t>(i)];
    if (bound(node, apart(node.witness))) node.leaf = Leaf::excluded;  // the level may be lower by now
    if (node.leaf == Leaf::excluded || is_settled(node)) return;
    if (node.region < 0 && node.cell.half <= small_cell && ask(node) && is_settled(node)) return;
    bound_by_points(node);
    const bool within_gap = node.bound > level_ - limits_.gap && node.cell.half < small_cell * small_cell;
    if (within_gap || node.cell.half <= tiny_cell) return;  // stays open
    const Cell cell = node.cell;
    int first = -1;
    for (int k = 0; k < 4; ++k) {
      const int child = add(cell.quarter(k));
      if (k == 0) first = child;
    }
    nodes_[static_cast<std::size_t>(i)].leaf = Leaf::split;
    nodes_[static_cast<std::size_t>(i)].children = first;
  }

  struct Question {
    Vec3<double> direction;
    double half;
  };

  /// Asks about a small cell, unless a neighbour of its kind has been asked about; whether a minimum came of it.
  bool ask(const Node& node) {
    if (asked_.size() >= limits_.questions) return false;
    const double half = node.cell.half > small_cell * small_cell ? small_cell : small_cell * small_cell;
    const Vec3<double> direction = (frame_ * node.cell.at(0, 0)).normalized();
    for (const Question& other : asked_)
      if (other.half == half && (other.direction - direction).norm() < 16 * half) return false;
    asked_.push_back({direction, half});
    const std::size_t before = minima_.size();
    learn(settle_(direction));
    return minima_.size() > before;
  }

  void write(int i) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    result_.cover.tree.push_back(node.leaf);
    if (node.leaf == Leaf::split) {
      for (int k = 0; k < 4; ++k) write(node.children + k);
      return;
    }
    if (node.leaf == Leaf::convex || node.leaf == Leaf::bounded) result_.cover.regions_of.push_back(node.region);
    if (node.leaf != Leaf::convex) {
      result_.cover.witnesses.push_back(node.witness);
      if (node.leaf == Leaf::open) open_.emplace_back(node.bound, (frame_ * node.cell.at(0, 0)).normalized());
    }
  }

  const PlacedPair<double>& pair_;
  double level_;
  const CoverLimits limits_;
  const Settle& settle_;
  const Mat3<double> frame_, to_body1_, to_body2_;
  const Vec3<double> centre_;
  std::vector<KnownMinimum> minima_;
  std::vector<Node> nodes_;
  std::priority_queue<std::pair<double, int>> queue_;  // highest -bound first
  std::vector<Question> asked_;
  std::vector<std::pair<double, Vec3<double>>> open_;
  CoverResult result_;
};

}  // namespace

Witness witness_of(const PlacedPair<double>& pair, const Vec3<double>& point1, const Vec3<double>& point2) {
  return {drawn_in(pair.body1.shape, pair.body1.to_body(point1)),
          drawn_in(pair.body2.shape, pair.body2.to_body(point2))};
}

Witness witness_along(const PlacedPair<double>& pair, const Vec3<double>& n) {
  return {witness_point(pair.body1.shape, pair.body1.to_body_direction(n)),
          witness_point(pair.body2.shape, pair.body2.to_body_direction(-n))};
}

CoverResult search_cover(const PlacedPair<double>& pair, const Mat3<double>& frame, double level,
                         const std::vector<KnownMinimum>& minima, const CoverLimits& limits, const Settle& settle) {
  return CoverSearch(pair, frame, level, minima, limits, settle).run();
}

}  // namespace plumb::reference
