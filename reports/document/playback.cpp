#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "corpus/case/case.hpp"
#include "reports/document/document.hpp"
#include "reports/document/json_lines.hpp"
#include "reports/document/packed.hpp"

namespace plumb::reports {
namespace {

bool yes_or_no(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value().get<bool>();
}

double above_zero(const Field& field) {
  const double x = field.number();
  if (!(x > 0)) field.fail("must be above 0");
  return x;
}

/// A count that need not fit into an int.
Json tally(const Field& field) {
  const double x = field.number();
  if (x < 0 || x != std::floor(x)) field.fail("is no count");
  return field.value();
}

std::vector<double> many_numbers(const Field& field, std::size_t size) {
  std::vector<double> out;
  out.reserve(size);
  for (std::size_t i = 0; i < size; ++i) out.push_back(field.element(i, size, "numbers").number());
  if (size == 0 && !field.elements().empty()) field.fail("must be empty");
  return out;
}

void require_map(const Field& field) {
  if (!field.value().is_object()) field.fail("must be an object");
}

/// In units of the playback's size; what is beyond is too far to be seen, as of Packed.
double in_units(double length, double size) {
  constexpr double largest = 1e30;
  return std::clamp(length / size, -largest, largest);
}

Json round_wall(const Field& wall, std::array<double, 2> radii, std::array<double, 2> heights, double size) {
  const Field closed = wall.member("closed");
  Json ends = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    radii[k] = in_units(radii[k], size);
    heights[k] = in_units(heights[k], size);
    ends.push_back(yes_or_no(closed.element(k, 2, "values")));
  }
  return {{"radii", radii}, {"heights", heights}, {"closed", ends}};
}

Json cylinder_wall(const Field& wall, double size) {
  const double radius = above_zero(wall.member("radius")), half = above_zero(wall.member("half_length"));
  return round_wall(wall, {radius, radius}, {-half, half}, size);
}

Json cone_wall(const Field& wall, double size) {
  const Field radii = wall.member("radii");
  const auto [least, most] = std::ranges::minmax(radii.numbers<2>());
  if (least < 0 || most == 0) radii.fail("must not be below 0, nor both 0");
  return round_wall(wall, radii.numbers<2>(), {0, above_zero(wall.member("height"))}, size);
}

Json box_wall(const Field& wall, double size) {
  const Field given = wall.member("half_extents");
  Json out = Json::array();
  for (std::size_t i = 0; i < 3; ++i) out.push_back(in_units(above_zero(given.element(i, 3, "numbers")), size));
  return {{"half_extents", out}};
}

Json mesh_wall(const Field& wall, double size) {
  const Field given = wall.member("triangles");
  const std::vector<Field> numbers = given.elements();
  if (numbers.empty() || numbers.size() % 9 != 0) given.fail("must hold nine numbers a triangle");
  Packed packed;
  for (const Field& x : numbers) packed.add_float(x.number() / size);
  return {{"triangles", packed.text()}};
}

struct ShapeOfWall {
  std::string_view name;
  Json (*read)(const Field& wall, double size);
};
constexpr std::array<ShapeOfWall, 4> shapes_of_walls{
    {{"mesh", mesh_wall}, {"cylinder", cylinder_wall}, {"cone", cone_wall}, {"box", box_wall}}};

/// null of a plane, and of what stands there without the numbers to draw it.
Json wall_shape(const Field& wall, double size) {
  const auto shape = wall.find("shape");
  if (!shape) return nullptr;
  const std::string name = shape->text();
  const auto row = std::ranges::find(shapes_of_walls, name, &ShapeOfWall::name);
  if (row == shapes_of_walls.end()) shape->fail("must be one of mesh, cylinder, cone, box");
  const auto numbers = wall.find(name);
  return numbers ? row->read(*numbers, size) : Json();
}

Json effects_json(const Field& effects) {
  Json out = Json::array();
  for (const Field& effect : effects.elements())
    out.push_back({{"name", effect.member("name").text()},
                   {"on", yes_or_no(effect.member("on"))},
                   {"why", effect.member("why").text()}});
  return out;
}

Json end_json(const Field& end) {
  const Field hash = end.member("hash"), shares = end.member("shares");
  const std::string digits = hash.text();
  const bool is_hash = digits.size() == 16 &&
                       std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (!is_hash) hash.fail("must be 16 hexadecimal digits");
  require_map(shares);
  Json parts = Json::object();
  for (const auto& [what, share] : shares.value().items()) parts[what] = shares.member(what).number();
  return {{"steps", tally(end.member("steps"))},   {"time", end.member("time").number()},   {"hash", digits},
          {"solves", tally(end.member("solves"))}, {"failed", tally(end.member("failed"))}, {"shares", parts}};
}

/// Lines into what the page reads: lengths from `origin`, in units of the largest semi-axis.
class PlaybackReader {
 public:
  void take(const Field& line) {
    if (ended_) throw FieldError("end", "stands in a line before, which is to be the last");
    if (bodies_ == 0)
      take_head(line);
    else if (line.has("end")) {
      out_["end"] = end_json(line.member("end"));
      ended_ = true;
    } else
      take_frame(line);
  }

  [[nodiscard]] std::size_t frames() const { return frames_; }

  [[nodiscard]] Json document() {
    for (const char* what : {"energy", "bulk"})
      for (auto& [name, values] : out_[what].items()) pad(values, frames_);
    const double largest = largest_force();
    Packed forces;
    for (const double force : forces_) forces.add_part(largest > 0 ? force / largest : 0);
    out_["positions"] = positions_.text();
    out_["orientations"] = orientations_.text();
    out_["wall_points"] = wall_points_.text();
    out_["wall_orientations"] = wall_orientations_.text();
    out_["contacts"]["largest_force"] = largest;
    out_["contacts"]["boxes"] = boxes_.text();
    out_["contacts"]["pairs"] = pairs_.text();
    out_["contacts"]["points"] = points_.text();
    out_["contacts"]["normals"] = normals_.text();
    out_["contacts"]["forces"] = forces.text();
    return std::move(out_);
  }

 private:
  struct Contact {
    std::array<std::uint32_t, 2> pair{};
    std::array<double, 3> point{}, normal{};
    double overlap = 0, force = 0;
  };

  void take_head(const Field& head) {
    head.member("format").require_text("plumb/playback-1");
    out_["scene"] = head.member("scene").text();
    out_["time_step"] = head.member("time_step").number();
    out_["accuracy"] = head.member("accuracy").number();
    out_["effects"] = effects_json(head.member("effects"));
    take_bodies(head.member("bodies"));
    take_walls(head.member("walls").elements());
    out_["times"] = Json::array();
    out_["contacts"] = {{"counts", Json::array()}, {"deepest", Json::array()}};
    out_["energy"] = Json::object();
    out_["bulk"] = Json::object();
    out_["end"] = nullptr;
  }

  void take_walls(const std::vector<Field>& walls) {
    out_["walls"] = Json::array();
    out_["wall_shapes"] = Json::array();
    for (const Field& wall : walls) {
      const std::array<double, 3> normal = direction(wall.member("normal"), wall.member("normal").numbers<3>());
      const Json shape = wall_shape(wall, size_);
      out_["walls"].push_back(wall.has("shape") ? std::array<double, 3>{} : normal);
      out_["wall_shapes"].push_back(shape);
      walls_turn_ = walls_turn_ || !shape.is_null();
    }
    walls_ = walls.size();
  }

  /// Bodies of one shape share it.
  void take_bodies(const Field& bodies) {
    out_["shapes"] = Json::array();
    out_["bodies"] = Json::array();
    out_["fixed"] = Json::array();
    std::map<std::string, std::size_t> known;
    for (const Field& body : bodies.elements()) {
      const Json shape = shape_of(body);
      const auto [at, is_new] = known.emplace(shape.dump(), known.size());
      if (is_new) out_["shapes"].push_back(shape);
      out_["bodies"].push_back(at->second);
      if (yes_or_no(body.member("fixed"))) out_["fixed"].push_back(bodies_);
      ++bodies_;
    }
    if (bodies_ == 0) bodies.fail("is empty");
    out_["size"] = size_;
  }

  Json shape_of(const Field& body) {
    Json out{{"semi_axes", Json::array()}, {"exponents", Json::array()}};
    const Field axes = body.member("semi_axes"), exponents = body.member("exponents");
    for (std::size_t i = 0; i < 3; ++i) {
      out["semi_axes"].push_back(above_zero(axes.element(i, 3, "numbers")));
      size_ = std::max(size_, out["semi_axes"].back().get<double>());
    }
    for (std::size_t i = 0; i < 2; ++i) out["exponents"].push_back(above_zero(exponents.element(i, 2, "numbers")));
    return out;
  }

  void take_frame(const Field& line) {
    const Field time = line.member("time");
    if (frames_ > 0 && time.number() < out_["times"].back().get<double>()) time.fail("is before the frame before it");
    take_positions(line.member("position"));
    pack_orientations(orientations_, line.member("orientation"), bodies_);
    if (walls_ > 0) pack_points(wall_points_, many_numbers(line.member("wall"), 3 * walls_));
    if (walls_turn_) pack_orientations(wall_orientations_, line.member("wall_orientation"), walls_);
    take_contacts(line.member("contacts").elements());
    take_series("energy", line.member("energy"));
    if (line.has("bulk")) take_series("bulk", line.member("bulk"));
    out_["times"].push_back(time.number());
    ++frames_;
  }

  void take_positions(const Field& field) {
    const std::vector<double> x = many_numbers(field, 3 * bodies_);
    if (frames_ == 0) {
      for (std::size_t i = 0; i < x.size(); ++i) origin_[i % 3] += x[i] / static_cast<double>(bodies_);
      out_["origin"] = origin_;
    }
    pack_points(positions_, x);
  }

  [[nodiscard]] double from_origin(double x, std::size_t axis) const { return (x - origin_[axis]) / size_; }

  void pack_points(Packed& out, const std::vector<double>& x) const {
    for (std::size_t i = 0; i < x.size(); ++i) out.add_float(from_origin(x[i], i % 3));
  }

  static void pack_orientations(Packed& out, const Field& field, std::size_t count) {
    const std::vector<double> q = many_numbers(field, 4 * count);
    for (std::size_t i = 0; i < q.size(); i += 4) {
      const double norm = std::hypot(std::hypot(q[i], q[i + 1]), std::hypot(q[i + 2], q[i + 3]));
      if (!(norm > 0)) field.element(i, q.size(), "numbers").fail("begins a quaternion of length 0");
      for (std::size_t part = i; part < i + 4; ++part) out.add_part(q[part] / norm);
    }
  }

  static std::array<double, 3> direction(const Field& field, const std::array<double, 3>& n) {
    const double norm = std::hypot(n[0], n[1], n[2]);
    if (!(norm > 0)) field.fail("has a normal of length 0");
    return {n[0] / norm, n[1] / norm, n[2] / norm};
  }

  [[nodiscard]] Contact contact_of(const Field& field) const {
    const auto x = field.numbers<10>();
    const auto last = static_cast<int>(bodies_ + walls_) - 1;
    const int i = field.element(0, 10, "numbers").whole_number(0, static_cast<int>(bodies_) - 1);
    const int j = field.element(1, 10, "numbers").whole_number(0, last);
    if (j <= i) field.element(1, 10, "numbers").fail("must be above the first body's");
    Contact out;
    out.pair = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)};
    for (std::size_t axis = 0; axis < 3; ++axis) out.point[axis] = from_origin(x[2 + axis], axis);
    out.normal = direction(field, {x[5], x[6], x[7]});
    out.overlap = x[8];
    out.force = x[9];
    return out;
  }

  void take_contacts(const std::vector<Field>& fields) {
    std::vector<Contact> contacts;
    for (const Field& field : fields) contacts.push_back(contact_of(field));
    Json deepest;
    for (const Contact& c : contacts)
      if (deepest.is_null() || c.overlap > deepest.get<double>()) deepest = c.overlap;
    out_["contacts"]["counts"].push_back(contacts.size());
    out_["contacts"]["deepest"].push_back(deepest);
    pack_contacts(contacts);
  }

  /// A point is a part of the box that holds all of its frame, in 65535ths.
  void pack_contacts(const std::vector<Contact>& contacts) {
    std::array<double, 3> low{}, range{};
    for (std::size_t axis = 0; axis < 3 && !contacts.empty(); ++axis) {
      const auto [least, most] =
          std::minmax_element(contacts.begin(), contacts.end(),
                              [axis](const Contact& a, const Contact& b) { return a.point[axis] < b.point[axis]; });
      low[axis] = least->point[axis];
      range[axis] = most->point[axis] - low[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) boxes_.add_float(low[axis]);
    for (std::size_t axis = 0; axis < 3; ++axis) boxes_.add_float(range[axis]);
    const int index_bytes = bodies_ + walls_ <= 65536 ? 2 : 4;
    for (const Contact& c : contacts) {
      for (const std::uint32_t index : c.pair) pairs_.add_whole(index, index_bytes);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double part = range[axis] > 0 ? (c.point[axis] - low[axis]) / range[axis] : 0;
        points_.add_whole(static_cast<std::uint32_t>(std::lround(65535 * part)), 2);
        normals_.add_part(c.normal[axis]);
      }
      forces_.push_back(c.force);
    }
  }

  /// A name that a frame does not have is null there.
  void take_series(const char* what, const Field& numbers) {
    require_map(numbers);
    for (const auto& [name, value] : numbers.value().items()) {
      Json& values = out_[what][name];
      pad(values, frames_);
      values.push_back(value.is_null() ? Json() : Json(numbers.member(name).number()));
    }
  }

  static void pad(Json& values, std::size_t size) {
    if (values.is_null()) values = Json::array();
    while (values.size() < size) values.push_back(nullptr);
  }

  [[nodiscard]] double largest_force() const {
    double largest = 0;
    for (const double force : forces_) largest = std::max(largest, std::abs(force));
    return largest;
  }

  Json out_ = Json::object();
  std::size_t bodies_ = 0, walls_ = 0, frames_ = 0;
  std::array<double, 3> origin_{};
  double size_ = 0;
  bool ended_ = false, walls_turn_ = false;
  Packed positions_, orientations_, wall_points_, wall_orientations_, boxes_, pairs_, points_, normals_;
  std::vector<double> forces_;
};

std::filesystem::path playback_file(const std::filesystem::path& folder) {
  return folder / "playback.jsonl";
}

}  // namespace

bool holds_playback(const std::filesystem::path& folder) {
  return std::filesystem::exists(playback_file(folder));
}

Json playback_json(const std::filesystem::path& folder) {
  const std::filesystem::path file = playback_file(folder);
  PlaybackReader reader;
  for_each_line(file, [&](const Field& line) { reader.take(line); });
  if (reader.frames() == 0) throw InputFailure(file.string(), 0, "", "holds no frame of plumb scene");
  Json out{{"name", folder_name(folder)}, {"folder", folder.string()}};
  out.update(reader.document());
  return out;
}

}  // namespace plumb::reports
