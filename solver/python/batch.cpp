#include "solver/python/strided_batch.hpp"

#include <algorithm>

#include "solver/python/arguments.hpp"
#include "solver/python/bindings.hpp"

namespace plumb::python {
namespace {

/// The package has seen to it: aligned, of the type, of as many columns, strides whole numbers of items.
template <class T>
[[nodiscard]] Column<T> column_of(const py::array& array, T* data, py::ssize_t offset) {
  return {data + offset, array.strides(0) / array.itemsize()};
}

/// Appends the columns of an array of shape (n,), (n, k) or (n, 2, 3) to those from `to` on.
void append_columns(py::array array, Column<double>*& to) {
  auto* const data = static_cast<double*>(array.mutable_data());
  const auto step = [&](py::ssize_t axis) { return array.strides(axis) / array.itemsize(); };
  const py::ssize_t bodies = array.ndim() == 3 ? array.shape(1) : 1;
  const py::ssize_t columns = array.ndim() == 1 ? 1 : array.shape(array.ndim() - 1);
  for (py::ssize_t b = 0; b < bodies; ++b)
    for (py::ssize_t k = 0; k < columns; ++k)
      *to++ = column_of(array, data, (bodies > 1 ? b * step(1) : 0) + (columns > 1 ? k * step(array.ndim() - 1) : 0));
}

[[nodiscard]] BodyColumns body_columns(const py::tuple& arrays) {
  BodyColumns out;
  auto* to = out.data();
  for (const py::handle item : arrays) {
    if (item.is_none()) continue;  // exponents, the last: all are 2
    const auto array = item.cast<py::array>();
    const auto* const data = static_cast<const double*>(array.data());
    for (py::ssize_t k = 0; k < array.shape(1); ++k)
      *to++ = column_of(array, data, k * (array.strides(1) / array.itemsize()));
  }
  return out;
}

template <class T>
[[nodiscard]] Column<T> word_column(const py::handle& item) {
  if (item.is_none()) return {};
  auto array = item.cast<py::array>();
  return column_of(array, static_cast<T*>(array.mutable_data()), 0);
}

/// status, verdict, overlap, normal, points, contact_point, iterations, evaluations, each an array or None.
[[nodiscard]] ContactColumns contact_columns(const py::tuple& arrays) {
  constexpr std::array<std::size_t, 4> widths{1, 3, 6, 3};
  ContactColumns out{word_column<Status>(arrays[0]),
                     word_column<Verdict>(arrays[1]),
                     {},
                     {word_column<int>(arrays[6]), word_column<int>(arrays[7])}};
  auto* to = out.numbers.data();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const py::object item = arrays[2 + i];
    if (item.is_none())
      to += widths[i];
    else
      append_columns(item.cast<py::array>(), to);
  }
  return out;
}

/// Whether no signal waits that Python would raise an exception for, as Ctrl-C does.
[[nodiscard]] bool no_signal() {
  const py::gil_scoped_acquire locked;
  return PyErr_CheckSignals() == 0;
}

[[nodiscard]] std::size_t solve_arrays(const py::tuple& body1, const py::tuple& body2, const py::tuple& contacts,
                                       std::size_t size, const py::object& iteration_limit, const py::object& tolerance,
                                       const py::object& threads) {
  StridedBatch batch{size, body_columns(body1), body_columns(body2), contact_columns(contacts), {}};
  batch.want.iteration_limit = count_of(iteration_limit, "iteration_limit");
  batch.want.tolerance = tolerance_of(tolerance, "tolerance");
  const int workers = std::min(count_of(threads, "threads"), 1024);
  BatchRun run;
  {
    const py::gil_scoped_release unlocked;
    run = solve_strided(batch, workers, no_signal);
  }
  if (!run.complete) throw py::error_already_set();
  return run.alone;
}

}  // namespace

void add_batch(py::module_& module) {
  module.def("solve_batch", &solve_arrays);
}

}  // namespace plumb::python
