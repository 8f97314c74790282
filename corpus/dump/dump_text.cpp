#include "corpus/dump/dump_text.hpp"

#include "corpus/json/json_text.hpp"

namespace plumb {

void DumpBounds::include(const Vec3<double>& centre, double radius) {
  low = low.cwiseMin(Vec3<double>(centre.array() - radius));
  high = high.cwiseMax(Vec3<double>(centre.array() + radius));
}

std::string dump_column_names(DumpFormat format) {
  if (format == DumpFormat::liggghts)
    return "id type x y z quat1 quat2 quat3 quat4 shapex shapey shapez blockiness1 blockiness2";
  return "id type x y z quatw quati quatj quatk shapex shapey shapez block1 block2"
         " SuperquadricRoundness.Phi SuperquadricRoundness.Theta";
}

std::string dump_head(std::int64_t step, std::optional<double> time, std::size_t count, const DumpBounds& bounds,
                      const std::string& columns) {
  std::string text = time ? "ITEM: TIME\n" + shortest(*time) + "\n" : "";
  text += "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" + std::to_string(count);
  text += "\nITEM: BOX BOUNDS";
  for (const bool is_periodic : bounds.is_periodic) text += is_periodic ? " pp" : " ss";
  text += "\n";
  for (int axis = 0; axis < 3; ++axis) text += shortest(bounds.low[axis]) + " " + shortest(bounds.high[axis]) + "\n";
  return text + "ITEM: ATOMS " + columns + "\n";
}

void add_dump_numbers(std::string& text, std::span<const double> numbers) {
  for (const double x : numbers) text += " " + shortest(x);
}

void add_dump_body(std::string& text, DumpFormat format, std::size_t id, int type, const Body& body) {
  const auto& [axes, n1, n2] = body.shape;
  const bool is_lammps = format != DumpFormat::liggghts;
  const Vec3<double> shape = is_lammps ? Vec3<double>(2 * axes) : axes;
  text += std::to_string(id) + " " + std::to_string(type);
  add_dump_numbers(text, {body.position.data(), 3});
  add_dump_numbers(text, body.quaternion);
  add_dump_numbers(text, {shape.data(), 3});
  add_dump_numbers(text, std::array{n1, n2});
  if (is_lammps) add_dump_numbers(text, std::array{2 / n2, 2 / n1});
}

}  // namespace plumb
