#include "properties/doors/columns.hpp"

#include <algorithm>
#include <iterator>

namespace plumb {
namespace {

template <class T>
std::array<std::span<const T>, 3> spans_of(const std::array<std::vector<T>, 3>& vector) {
  return {vector[0], vector[1], vector[2]};
}

}  // namespace

PairColumns::PairColumns(std::span<const Pair> pairs) {
  for (const Pair& pair : pairs) {
    append(pair.body1, body1_);
    append(pair.body2, body2_);
  }
}

PairArrays PairColumns::arrays() const {
  return {arrays(body1_), arrays(body2_)};
}

void PairColumns::append(const Body& body, Columns& to) {
  const auto& [w, x, y, z] = body.quaternion;
  const Vec3<double>&a = body.shape.semi_axes, &p = body.position;
  std::size_t k = 0;
  for (const double value : {a[0], a[1], a[2], body.shape.n1, body.shape.n2, p[0], p[1], p[2], w, x, y, z})
    to[k++].push_back(value);
}

BodyArrays PairColumns::arrays(const Columns& of) {
  return {{of[0], of[1], of[2]}, of[3], of[4], {of[5], of[6], of[7]}, {of[8], of[9], of[10], of[11]}};
}

ContactColumns::ContactColumns(std::size_t size)
    : status(size), verdict(size), overlap(size), iterations(size), evaluations(size) {
  for (auto* vector : {&normal, &point1, &point2, &contact_point, &chart1, &chart2})
    for (auto& component : *vector) component.resize(size);
}

ContactArrays ContactColumns::arrays() {
  const auto spans = [](auto& v) { return std::array<std::span<double>, 3>{v[0], v[1], v[2]}; };
  return {status,     verdict,     overlap,       spans(normal), spans(point1), spans(point2), spans(contact_point),
          iterations, evaluations, spans(chart1), spans(chart2)};
}

BendColumns::BendColumns(std::size_t size) {
  for (auto* bend : {&bend1, &bend2}) bend->fill(std::vector<float>(size, std::numeric_limits<float>::quiet_NaN()));
}

void BendColumns::set(std::size_t i, const Vec3<float>& of1, const Vec3<float>& of2) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bend1[axis][i] = of1[static_cast<Eigen::Index>(axis)];
    bend2[axis][i] = of2[static_cast<Eigen::Index>(axis)];
  }
}

BendArrays BendColumns::arrays() const {
  return {spans_of(bend1), spans_of(bend2)};
}

ChartArrays ContactColumns::charts() const {
  return {spans_of(chart1), spans_of(chart2)};
}

Contact<double> ContactColumns::at(std::size_t i) const {
  const auto vector = [&](const auto& v) { return Vec3<double>(v[0][i], v[1][i], v[2][i]); };
  Contact<double> out;
  if (status[i] != Status::invalid_input) out.method = "auto";
  out.status = status[i];
  out.verdict = verdict[i];
  out.overlap = overlap[i];
  out.normal = vector(normal);
  out.point1 = vector(point1);
  out.point2 = vector(point2);
  out.contact_point = vector(contact_point);
  out.chart1 = vector(chart1);
  out.chart2 = vector(chart2);
  out.iterations = iterations[i];
  out.evaluations = evaluations[i];
  return out;
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> out;
  std::copy_if(instruction_sets.begin(), instruction_sets.end(), std::back_inserter(out), is_available);
  return out;
}

}  // namespace plumb
