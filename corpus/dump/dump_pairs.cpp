#include "corpus/dump/dump_pairs.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "corpus/command/interrupt.hpp"
#include "solver/method/automatic.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/contact/neighbours.hpp"

namespace plumb {
namespace {

using Image = std::array<int, 3>;
using scene::Column;
using scene::ColumnKind;

/// A body or an image of one: in the box (bodies), or near enough to it to be met from there (images).
struct Copy {
  std::size_t particle;
  Image image{};  ///< of the body in the box
};

Vec3<double> as_vector(const Image& image) {
  return Vec3<double>(image[0], image[1], image[2]);
}

/// Where the particles are in the box's edges, and how far each of them reaches there.
class Cell {
 public:
  Cell(const DumpFrame& frame, double gap) : frame_(frame), gap_(gap) {
    if (frame.box.repeats()) inverse_ = frame.box.edges.inverse();
    for (const DumpParticle& particle : frame.particles) greatest_ = std::max(greatest_, reach(particle.body));
    for (const DumpParticle& particle : frame.particles) shifts_.push_back(shift_into_box(particle.body.position));
  }

  /// The bodies, then their images.
  [[nodiscard]] std::vector<Copy> copies() const {
    std::vector<Copy> out;
    for (std::size_t i = 0; i < frame_.particles.size(); ++i) out.push_back({i, {}});
    if (!frame_.box.repeats()) return out;
    refuse_too_many();
    for (std::size_t i = 0; i < frame_.particles.size(); ++i) add_images(i, out);
    return out;
  }

  [[nodiscard]] Vec3<double> position(const Copy& copy) const {
    return shifted(frame_.particles[copy.particle].body.position, added(shifts_[copy.particle], copy.image));
  }

  /// Of body 2 of a pair of copies, as the pair is written down: body 1 stays where the dump has it.
  [[nodiscard]] Image image_between(const Copy& first, const Copy& second) const {
    Image out = added(shifts_[second.particle], second.image);
    for (std::size_t k = 0; k < 3; ++k) out[k] -= shifts_[first.particle][k];
    return out;
  }

  [[nodiscard]] Vec3<double> shifted(const Vec3<double>& position, const Image& image) const {
    if (image == Image{}) return position;
    return position + frame_.box.edges * as_vector(image);
  }

  /// How far beyond its surface a body looks for others.
  [[nodiscard]] double margin(const Body& body) const { return (gap_ + rounding) * body.shape.semi_axes.maxCoeff(); }

 private:
  static constexpr double rounding = 1e-9;  ///< boxes are no place for the last digits
  static constexpr double most_images = 2e7, most_boxes_away = 1e6;

  static Image added(Image a, const Image& b) {
    for (std::size_t k = 0; k < 3; ++k) a[k] += b[k];
    return a;
  }

  [[nodiscard]] double reach(const Body& body) const { return scene::bounding_radius(body.shape) + margin(body); }

  /// A length across the k-th pair of the box's faces, in distances of those.
  [[nodiscard]] double in_boxes(double length, int k) const { return length * inverse_.row(k).norm(); }

  [[nodiscard]] Image shift_into_box(const Vec3<double>& position) const {
    Image out{};
    if (!frame_.box.repeats()) return out;
    const Vec3<double> place = inverse_ * (position - frame_.box.origin);
    for (int k = 0; k < 3; ++k) {
      if (!frame_.box.is_periodic[static_cast<std::size_t>(k)]) continue;
      if (!(std::abs(place[k]) < most_boxes_away)) throw std::invalid_argument("a particle is 1e6 boxes away, or more");
      out[static_cast<std::size_t>(k)] = -static_cast<int>(std::floor(place[k]));
    }
    return out;
  }

  /// Images are so many that memory would not hold them where bodies are far larger than the box.
  void refuse_too_many() const {
    double sum = 0;
    for (const DumpParticle& particle : frame_.particles) {
      double images = 1;
      for (int k = 0; k < 3; ++k)
        if (frame_.box.is_periodic[static_cast<std::size_t>(k)])
          images *= 1 + 2 * in_boxes(reach(particle.body) + greatest_, k);
      sum += images;
    }
    if (!(sum <= most_images)) throw std::invalid_argument("the box is too small for its particles: over 2e7 images");
  }

  /// Those that a body in the box can touch.
  void add_images(std::size_t i, std::vector<Copy>& out) const {
    const Body& body = frame_.particles[i].body;
    const Vec3<double> place = inverse_ * (position({i, {}}) - frame_.box.origin);
    Image low{}, high{};
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      if (!frame_.box.is_periodic[axis]) continue;
      const double far = in_boxes(reach(body) + greatest_, k);
      low[axis] = static_cast<int>(std::ceil(-far - place[k]));
      high[axis] = static_cast<int>(std::floor(1 + far - place[k]));
    }
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        for (int c = low[2]; c <= high[2]; ++c)
          if (Image{a, b, c} != Image{}) out.push_back({i, {a, b, c}});
  }

  const DumpFrame& frame_;
  double gap_, greatest_ = 0;
  Mat3<double> inverse_ = Mat3<double>::Identity();
  std::vector<Image> shifts_;
};

/// The broad phase of scenes over copies that none of them moves.
std::vector<std::array<std::uint32_t, 2>> pairs_that_may_touch(const DumpFrame& frame, const Cell& cell,
                                                               const std::vector<Copy>& copies) {
  const auto column = [&](const char* name, int width) {
    Column out(name, "import", {ColumnKind::body, width, false, 0});
    out.renew(copies.size());
    return out;
  };
  Column position = column("position", 3), orientation = column("orientation", 4),
         boxes = column("box", scene::box_width);
  scene::World world;
  world.state.position = &position;
  world.state.orientation = &orientation;
  world.bodies.count = copies.size();
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const Body& body = frame.particles[copies[i].particle].body;
    const auto& q = body.quaternion;
    const double largest = std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2]), std::abs(q[3])});
    const Eigen::Vector4d unit = (Eigen::Vector4d(q[0], q[1], q[2], q[3]) / largest).normalized();
    std::ranges::copy(unit, orientation.entry(i).begin());
    position.vector(i) = cell.position(copies[i]);
    world.bodies.shape.push_back(body.shape);
    world.bodies.radius.push_back(scene::bounding_radius(body.shape));
    const Vec3<double> half = scene::half_extent(world, i).array() + cell.margin(body);
    Vec3<double>::Map(boxes.entry(i).data()) = position.vector(i) - half;
    Vec3<double>::Map(boxes.entry(i).data() + 3) = position.vector(i) + half;
  }
  return meeting_pairs(world, boxes);
}

using Candidate = std::tuple<std::size_t, std::size_t, Image>;

/// One of the two ways in which a pair of images comes up, and no pair between two images.
bool is_counted(const Copy& first, const Copy& second, std::size_t bodies, std::size_t second_index) {
  if (second_index < bodies) return true;
  return first.particle < second.particle || (first.particle == second.particle && second.image > Image{});
}

bool touches(const Pair& pair, double gap) {
  const bool is_yes_or_no = gap == 0;
  const Contact<double> answer = automatic<double>(pair, {!is_yes_or_no, false, false}, nullptr);
  if (answer.status != Status::converged) return true;
  return is_yes_or_no ? answer.verdict == Verdict::overlapping : answer.overlap > -gap * size_of(pair);
}

}  // namespace

void each_touching_pair(const DumpFrame& frame, double gap, const std::function<void(const DumpPair&)>& take) {
  const Cell cell(frame, gap);
  const std::vector<Copy> copies = cell.copies();
  const std::size_t bodies = frame.particles.size();
  std::vector<Candidate> found;
  for (const auto& [i, j] : pairs_that_may_touch(frame, cell, copies))
    if (i < bodies && is_counted(copies[i], copies[j], bodies, j))
      found.push_back({copies[i].particle, copies[j].particle, cell.image_between(copies[i], copies[j])});
  std::ranges::sort(found);
  for (const auto& [first, second, image] : found) {
    if (interrupted()) return;
    DumpPair out{first, second, image, {frame.particles[first].body, frame.particles[second].body}};
    out.pair.body2.position = cell.shifted(out.pair.body2.position, image);
    if (touches(out.pair, gap)) take(out);
  }
}

}  // namespace plumb
