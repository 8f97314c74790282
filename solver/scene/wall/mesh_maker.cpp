#include "solver/scene/wall/mesh_maker.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace plumb::scene {
namespace {

/// A corner this near to a facet's plane, relative to the mesh, is in it: what double coordinates of a tilted plane leave.
constexpr double in_plane = 1e-12;
/// A triangle's height over its longest side, below which its normal is not known well enough.
constexpr double least_height = 1e-7;
/// More sides at a corner than that: the normals that are tried are those of its facets alone.
constexpr std::size_t many_sides = 40;

Vec3<double> doubled_area(const Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

double longest_side(const Triangle& t) {
  return std::sqrt(std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

[[noreturn]] void refuse(std::size_t triangle, const char* reason) {
  throw std::invalid_argument("triangles[" + std::to_string(triangle) + "]: " + reason);
}

struct HashOfPoint {
  std::size_t operator()(const std::array<double, 3>& x) const {
    std::size_t hash = 0;
    for (const double number : x) hash = hash * 0x9e3779b97f4a7c15U + std::hash<double>{}(number);
    return hash;
  }
};

/// The lowest 21 bits, two free places after each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Places along Morton's curve in the box of all corners.
std::vector<std::uint64_t> places_of(std::span<const Triangle> triangles) {
  Vec3<double> low = triangles[0][0], high = low;
  for (const Triangle& t : triangles)
    for (const Vec3<double>& corner : t) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  constexpr double steps = 0x1fffff;
  const Vec3<double> side = high - low;
  std::vector<std::uint64_t> out;
  out.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3<double> middle = a / 3 + b / 3 + c / 3 - low;
    const auto bits = [&](int axis) {
      const double part = side[axis] > 0 ? middle[axis] / side[axis] : 0;
      return spread(static_cast<std::uint64_t>(steps * std::clamp(part, 0.0, 1.0)));
    };
    out.push_back(bits(0) | bits(1) << 1 | bits(2) << 2);
  }
  return out;
}

/// Whether a normal is away from all directions.
bool is_away(const Vec3<double>& n, std::span<const Vec3<double>> directions, double slack) {
  return std::ranges::all_of(directions, [&](const Vec3<double>& d) { return n.dot(d) <= slack; });
}

/// A normal inside the cone {n : n.d <= 0}: the sum of its extreme rays, which are across two of the directions, and of what is across one
/// of them in the plane of two, for a corner of a plane sheet.
Vec3<double> middle_of_cone(std::span<const Vec3<double>> directions) {
  constexpr double slack = 1e-13;
  Vec3<double> sum = Vec3<double>::Zero();
  const auto add = [&](const Vec3<double>& ray) {
    for (const double sign : {1.0, -1.0})
      if (const Vec3<double> n = sign * ray.normalized(); is_away(n, directions, slack)) sum += n;
  };
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3<double> ray = directions[i].cross(directions[j]);
      if (!(ray.norm() > slack)) continue;
      add(ray);
      add(directions[i].cross(ray));
      add(directions[j].cross(ray));
    }
  return sum;
}

/// Whether the cone has an inside.
bool sticks_out(std::span<const Vec3<double>> directions) {
  constexpr double least = 1e-9;
  if (directions.size() > many_sides) {
    const Vec3<double> sum = std::accumulate(directions.begin(), directions.end(), Vec3<double>(Vec3<double>::Zero()));
    return sum.norm() > 0 && is_away(-sum.normalized(), directions, -least);
  }
  const Vec3<double> middle = middle_of_cone(directions);
  return middle.norm() > 0 && is_away(middle.normalized(), directions, -least);
}

}  // namespace

void MeshMaker::make() {
  check_triangles();
  order_triangles();
  join_corners();
  list_joints();
  lay_together();
  order_facets();
  find_edges();
  find_corners();
}

void MeshMaker::check_triangles() const {
  constexpr std::size_t most = 100'000'000;
  if (mesh_.triangles_.empty()) throw std::invalid_argument("triangles: there is none");
  if (mesh_.triangles_.size() > most) throw std::invalid_argument("triangles: more than 100000000");
  for (std::size_t k = 0; k < mesh_.triangles_.size(); ++k) {
    const Triangle& t = mesh_.triangles_[k];
    constexpr double farthest = 1e100;  // areas and their squares are numbers
    for (const Vec3<double>& corner : t) {
      if (!corner.allFinite()) refuse(k, "must be finite numbers");
      if (corner.cwiseAbs().maxCoeff() > farthest) refuse(k, "is farther away than 1e100");
    }
    const double longest = longest_side(t);
    if (!(doubled_area(t).norm() > least_height * longest * longest)) refuse(k, "has no area");
  }
}

/// So that what a body is near lies together in memory, whatever the order in the file. In that order already, nothing changes.
void MeshMaker::order_triangles() {
  const std::vector<std::uint64_t> places = places_of(mesh_.triangles_);
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return places[k]; });
  std::vector<Triangle> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t k : order) ordered.push_back(mesh_.triangles_[k]);
  mesh_.triangles_ = std::move(ordered);
}

void MeshMaker::join_corners() {
  std::unordered_map<std::array<double, 3>, std::uint32_t, HashOfPoint> known;
  known.reserve(mesh_.triangles_.size());
  for (const Triangle& t : mesh_.triangles_) {
    auto& of = corners_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3> at{t[k].x() + 0.0, t[k].y() + 0.0, t[k].z() + 0.0};  // -0 is 0
      of[k] = known.try_emplace(at, static_cast<std::uint32_t>(known.size())).first->second;
      mesh_.extent_ = std::max(mesh_.extent_, t[k].norm());
    }
  }
  corner_count_ = static_cast<std::uint32_t>(known.size());
}

void MeshMaker::list_joints() {
  for (std::uint32_t triangle = 0; triangle < corners_.size(); ++triangle)
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(corners_[triangle][side], corners_[triangle][(side + 1) % 3]);
      joints_.push_back({{low, high}, {triangle, side}});
    }
  std::ranges::stable_sort(joints_, {}, &Joint::ends);
  joint_of_.resize(corners_.size());
  for (std::uint32_t k = 0; k < joints_.size(); ++k) joint_of_[joints_[k].side.triangle][joints_[k].side.side] = k;
}

/// Its corners, to rounding; and its sides, for one that is as small as rounding may stand on the plane or be tilted against it.
bool MeshMaker::is_in_plane(const MeshFacet& facet, std::uint32_t triangle) const {
  constexpr double steepest = 1e-5;  // sine; corners far from the origin tilt small triangles
  const Triangle& t = mesh_.triangles_[triangle];
  const auto height = [&](const Vec3<double>& x) { return std::abs(facet.normal.dot(x)); };
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<double> side = t[(k + 1) % 3] - t[k];
    const bool lies = height(t[k] - facet.point) <= in_plane * mesh_.extent_;
    if (!lies || height(side) > steepest * side.norm()) return false;
  }
  return true;
}

/// From the greatest triangles on: their normals are known best.
void MeshMaker::lay_together() {
  mesh_.parts_.resize(corners_.size());
  mesh_.is_reversed_.resize(corners_.size());
  std::vector<double> areas(corners_.size());
  std::ranges::transform(mesh_.triangles_, areas.begin(), [](const Triangle& t) { return doubled_area(t).norm(); });
  std::vector<std::uint32_t> order(corners_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
  for (const std::uint32_t seed : order)
    if (mesh_.parts_[seed].facet == Mesh::none) fill_facet(seed);
}

/// All that is joined to it by sides of two triangles and lies in its plane.
void MeshMaker::fill_facet(std::uint32_t seed) {
  const Triangle& t = mesh_.triangles_[seed];
  const MeshFacet facet{doubled_area(t).normalized(), t[0]};
  const auto index = static_cast<std::uint32_t>(mesh_.facets_.size());
  mesh_.facets_.push_back(facet);
  mesh_.parts_[seed].facet = index;
  std::vector<std::uint32_t> front{seed}, members;
  while (!front.empty()) {
    const std::uint32_t triangle = front.back();
    front.pop_back();
    members.push_back(triangle);
    mesh_.is_reversed_[triangle] = doubled_area(mesh_.triangles_[triangle]).dot(facet.normal) < 0 ? 1 : 0;
    for (const std::uint32_t at : joint_of_[triangle]) {
      const auto [first, last] = std::ranges::equal_range(joints_, joints_[at].ends, {}, &Joint::ends);
      if (last - first != 2) continue;
      for (auto other = first; other != last; ++other) {
        Mesh::Parts& parts = mesh_.parts_[other->side.triangle];
        if (parts.facet != Mesh::none || !is_in_plane(facet, other->side.triangle)) continue;
        parts.facet = index;
        front.push_back(other->side.triangle);
      }
    }
  }
  sharpen(mesh_.facets_[index], members);
}

/// As their first triangles.
void MeshMaker::order_facets() {
  std::vector<std::uint32_t> place(mesh_.facets_.size(), Mesh::none);
  std::vector<MeshFacet> ordered;
  ordered.reserve(mesh_.facets_.size());
  for (Mesh::Parts& parts : mesh_.parts_) {
    std::uint32_t& at = place[parts.facet];
    if (at == Mesh::none) {
      at = static_cast<std::uint32_t>(ordered.size());
      ordered.push_back(mesh_.facets_[parts.facet]);
    }
    parts.facet = at;
  }
  mesh_.facets_ = std::move(ordered);
}

/// The normal by three corners that are far apart: what rounding does to the corners of one triangle is less there.
void MeshMaker::sharpen(MeshFacet& facet, std::span<const std::uint32_t> members) const {
  const auto farthest = [&](const auto& distance) {
    Vec3<double> best = facet.point;
    for (const std::uint32_t triangle : members)
      for (const Vec3<double>& corner : mesh_.triangles_[triangle])
        if (distance(corner) > distance(best)) best = corner;
    return best;
  };
  const Vec3<double> a = farthest([&](const Vec3<double>& x) { return (x - facet.point).squaredNorm(); });
  const Vec3<double> b = farthest([&](const Vec3<double>& x) { return (x - a).squaredNorm(); });
  const Vec3<double> c = farthest([&](const Vec3<double>& x) { return (x - a).cross(b - a).squaredNorm(); });
  const Vec3<double> normal = (b - a).cross(c - a).normalized();
  facet.normal = normal.dot(facet.normal) < 0 ? Vec3<double>(-normal) : normal;
}

Vec3<double> MeshMaker::inward_of(TriangleSide at) const {
  const Triangle& t = mesh_.triangles_[at.triangle];
  const Vec3<double> across =
      mesh_.facets_[mesh_.parts_[at.triangle].facet].normal.cross(t[(at.side + 1) % 3] - t[at.side]);
  return (mesh_.is_reversed_[at.triangle] != 0 ? -across : across).normalized();
}

template <class Visit>
void MeshMaker::each_edge(const Visit& visit) const {
  for (auto first = joints_.begin(); first != joints_.end();) {
    const auto last = std::find_if(first, joints_.end(), [&](const Joint& joint) { return joint.ends != first->ends; });
    visit(std::span(first, last));
    first = last;
  }
}

void MeshMaker::find_edges() {
  each_edge([&](std::span<const Joint> joints) { find_edge(joints); });
}

/// The arc is what the widest gap between the directions into the triangles is more than half a turn.
void MeshMaker::find_edge(std::span<const Joint> joints) {
  constexpr double half = std::numbers::pi, least_width = 1e-14;
  const auto parts_at = [&](const Joint& joint) -> Mesh::Parts& { return mesh_.parts_[joint.side.triangle]; };
  const Vec3<double> zero = inward_of(joints[0].side),
                     axis = mesh_.facets_[parts_at(joints[0]).facet].normal.cross(zero);
  const Vec3<double> quarter = axis.normalized().cross(zero);
  struct Direction {
    double angle;
    TriangleSide side;
  };
  std::vector<Direction> around;
  for (const Joint& joint : joints) {
    const Vec3<double> f = inward_of(joint.side);
    around.push_back({std::atan2(f.dot(quarter), f.dot(zero)), joint.side});
  }
  std::ranges::sort(around, {}, &Direction::angle);
  if (joints.size() == 2 && parts_at(joints[0]).facet == parts_at(joints[1]).facet &&
      zero.dot(inward_of(joints[1].side)) < 0) {
    for (const Joint& joint : joints) parts_at(joint).is_flat[joint.side.side] = true;
    return;
  }
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Direction &a = around[k], &b = around[(k + 1) % around.size()];
    const double gap = k + 1 < around.size() ? b.angle - a.angle : around[0].angle + 2 * half - a.angle;
    if (!(gap - half > least_width)) continue;
    const Vec3<double> inward = inward_of(a.side), turned = axis.normalized().cross(inward);
    const auto normal_like = [&](TriangleSide side, const Vec3<double>& like) -> Vec3<double> {
      const Vec3<double>& n = mesh_.facets_[mesh_.parts_[side.triangle].facet].normal;
      return n.dot(like) < 0 ? Vec3<double>(-n) : n;
    };
    const Vec3<double> start = normal_like(a.side, turned),
                       end = normal_like(b.side, -axis.normalized().cross(inward_of(b.side)));
    const Triangle& t = mesh_.triangles_[a.side.triangle];
    const auto index = static_cast<std::uint32_t>(mesh_.edges_.size());
    mesh_.edges_.push_back(
        {{a.side, b.side}, t[a.side.side], t[(a.side.side + 1) % 3], start, end, inward, gap - half});
    mesh_.parts_[a.side.triangle].edges[a.side.side] = index;
  }
}

void MeshMaker::find_corners() {
  struct End {
    std::uint32_t corner, other;
    TriangleSide side;
  };
  std::vector<End> ends;
  each_edge([&](std::span<const Joint> joints) {
    const TriangleSide side = joints[0].side;
    const auto [a, b] = joints[0].ends;
    ends.push_back({a, b, side});
    ends.push_back({b, a, side});
  });
  std::ranges::stable_sort(ends, {}, &End::corner);
  for (auto first = ends.begin(); first != ends.end();) {
    const std::uint32_t corner = first->corner;
    std::vector<Vec3<double>> directions;
    auto end = first;
    for (; end != ends.end() && end->corner == corner; ++end) {
      const auto& of = corners_[end->side.triangle];
      const Triangle& t = mesh_.triangles_[end->side.triangle];
      const auto place = [&](std::uint32_t which) {
        return t[static_cast<std::size_t>(std::ranges::find(of, which) - of.begin())];
      };
      directions.push_back((place(end->other) - place(corner)).normalized());
    }
    find_corner(corner, directions, first->side);
    first = end;
  }
}

void MeshMaker::find_corner(std::uint32_t corner, std::vector<Vec3<double>>& directions, TriangleSide first) {
  if (!sticks_out(directions)) return;
  const auto& of = corners_[first.triangle];
  const auto k = static_cast<std::size_t>(std::ranges::find(of, corner) - of.begin());
  mesh_.parts_[first.triangle].corners[k] = static_cast<std::uint32_t>(mesh_.corners_.size());
  mesh_.corners_.push_back({mesh_.triangles_[first.triangle][k], first.triangle,
                            static_cast<std::uint32_t>(mesh_.directions_.size()),
                            static_cast<std::uint32_t>(directions.size())});
  mesh_.directions_.insert(mesh_.directions_.end(), directions.begin(), directions.end());
}

}  // namespace plumb::scene
