#include "solver/scene/wall/mesh.hpp"

#include <Eigen/Geometry>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "solver/scene/wall/mesh_maker.hpp"

namespace plumb::scene {
namespace {

namespace space = boost::geometry;
using TreePoint = space::model::point<double, 3, space::cs::cartesian>;
using TreeBox = space::model::box<TreePoint>;
using TreeEntry = std::pair<TreeBox, std::uint32_t>;
using TriangleTree = space::index::rtree<TreeEntry, space::index::linear<16>>;

TreeBox tree_box(const Vec3<double>& low, const Vec3<double>& high) {
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

TriangleTree tree_of(std::span<const Triangle> triangles) {
  std::vector<TreeEntry> entries;
  entries.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    entries.emplace_back(tree_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)),
                         static_cast<std::uint32_t>(entries.size()));
  return TriangleTree(entries);  // packed: built at once
}

}  // namespace

struct Mesh::Tree {
  TriangleTree of;
};

Mesh::Mesh(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
  MeshMaker(*this).make();
  tree_ = std::make_unique<const Tree>(Tree{tree_of(triangles_)});
}

Mesh::~Mesh() = default;

double Mesh::inwards(TriangleSide at, const Vec3<double>& point) const {
  const Triangle& t = triangles_[at.triangle];
  const Vec3<double>&from = t[at.side], &to = t[(at.side + 1) % 3];
  const double way = facets_[parts_[at.triangle].facet].normal.cross(to - from).dot(point - from);
  return is_reversed_[at.triangle] != 0 ? -way : way;
}

void Mesh::near(const Vec3<double>& low, const Vec3<double>& high, std::vector<std::uint32_t>& out) const {
  const auto add = boost::make_function_output_iterator([&](const TreeEntry& met) { out.push_back(met.second); });
  tree_->of.query(space::index::intersects(tree_box(low, high)), add);
}

}  // namespace plumb::scene
