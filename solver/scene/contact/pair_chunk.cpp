#include "solver/scene/contact/pair_chunk.hpp"

#include <cassert>

namespace plumb::scene {
namespace {

template <class Vectors, class From>
void put(Vectors& columns, std::size_t k, const From& from) {
  using Number = std::remove_reference_t<decltype(columns[0][0])>;
  for (std::size_t axis = 0; axis < columns.size(); ++axis) columns[axis][k] = static_cast<Number>(from[axis]);
}

template <class Vectors>
Vec3<double> vector_at(const Vectors& columns, std::size_t k) {
  return {columns[0][k], columns[1][k], columns[2][k]};
}

/// The first entries of each column.
template <class Columns>
auto firsts(Columns& columns, std::size_t count) {
  using Span = std::span<std::remove_reference_t<decltype(columns[0][0])>>;
  std::array<Span, std::tuple_size_v<std::remove_const_t<Columns>>> out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = Span(columns[k]).first(count);
  return out;
}

}  // namespace

void PairChunk::set(const World& world, std::size_t body, const Vec3<double>& position, std::size_t k, Side& to) {
  const Superellipsoid<double>& shape = world.bodies.shape[body];
  const Eigen::Quaterniond q = world.solver_orientation(body);
  put(to.semi_axes, k, std::span(shape.semi_axes.data(), 3));
  to.n1[k] = shape.n1;
  to.n2[k] = shape.n2;
  put(to.position, k, std::span(position.data(), 3));
  put(to.quaternion, k, std::array{q.w(), q.x(), q.y(), q.z()});
}

void PairChunk::add(const World& world, std::size_t contact) {
  const auto [i, j] = world.contacts.pairs[contact];
  set(world, i, world.state.position->vector(i), count_, side1_);
  set(world, j, world.second_position(contact), count_, side2_);
  const auto charts = world.contacts.chart->entry(contact);
  std::size_t of_body = 0;
  for (Side* side : {&side1_, &side2_}) {
    put(side->last, count_, charts.subspan(ChartEntry::last + of_body, 3));
    put(side->before_last, count_, charts.subspan(ChartEntry::before_last + of_body, 3));
    put(side->bend, count_, charts.subspan(ChartEntry::bend + of_body, 3));
    of_body += 3;
  }
  ++count_;
}

BodyArrays PairChunk::arrays(const Side& of) const {
  return {firsts(of.semi_axes, count_), std::span(of.n1).first(count_), std::span(of.n2).first(count_),
          firsts(of.position, count_), firsts(of.quaternion, count_)};
}

PairArrays PairChunk::pairs() const {
  return {arrays(side1_),
          arrays(side2_),
          {firsts(side1_.last, count_), firsts(side2_.last, count_)},
          {firsts(side1_.before_last, count_), firsts(side2_.before_last, count_)},
          {firsts(side1_.bend, count_), firsts(side2_.bend, count_)}};
}

ContactArrays PairChunk::verdicts() {
  ContactArrays to;
  to.status = std::span(status_).first(count_);
  to.verdict = std::span(verdict_).first(count_);
  to.chart1 = firsts(chart1_, count_);
  to.chart2 = firsts(chart2_, count_);
  to.iterations = std::span(iterations_).first(count_);
  to.evaluations = std::span(evaluations_).first(count_);
  return to;
}

void PairChunk::ask(const Want& want, bool with_direction) {
  is_solved_ = false;
  has_normal_ = with_direction;
  ContactArrays to = verdicts();
  if (with_direction) to.separating = firsts(normal_, count_);
  run(want, to);
}

void PairChunk::solve(const Want& want) {
  is_solved_ = has_normal_ = true;
  ContactArrays to = verdicts();
  to.overlap = std::span(overlap_).first(count_);
  to.normal = firsts(normal_, count_);
  to.point1 = firsts(point1_, count_);
  to.point2 = firsts(point2_, count_);
  to.contact_point = firsts(contact_point_, count_);
  run(want, to);
}

void PairChunk::run(const Want& want, const ContactArrays& to) {
  [[maybe_unused]] const BatchReport report = solve_batch(pairs(), want, to);
  assert(report.error == BatchError::none);
}

Contact<double> PairChunk::answer(std::size_t k) const {
  Contact<double> out;
  out.status = status_[k];
  out.verdict = verdict_[k];
  out.chart1 = vector_at(chart1_, k);
  out.chart2 = vector_at(chart2_, k);
  out.iterations = iterations_[k];
  out.evaluations = evaluations_[k];
  if (has_normal_) out.normal = vector_at(normal_, k);
  if (!is_solved_) return out;
  out.overlap = overlap_[k];
  out.point1 = vector_at(point1_, k);
  out.point2 = vector_at(point2_, k);
  out.contact_point = vector_at(contact_point_, k);
  return out;
}

}  // namespace plumb::scene
