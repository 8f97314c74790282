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

/// Appends the columns of an array of shape (n, ..), the last index fastest, to those from `to` on.
template <class T>
void append_columns(const py::array& array, T* data, Column<T>*& to, py::ssize_t axis = 1) {
  if (axis == array.ndim()) {
    *to++ = column_of(array, data, 0);
    return;
  }
  const py::ssize_t step = array.strides(axis) / array.itemsize();
  for (py::ssize_t k = 0; k < array.shape(axis); ++k) append_columns(array, data + k * step, to, axis + 1);
}

[[nodiscard]] BodyColumns body_columns(const py::tuple& arrays) {
  BodyColumns out;
  auto* to = out.data();
  for (const py::handle item : arrays) {
    if (item.is_none()) continue;  // exponents, the last: all are 2
    const auto array = item.cast<py::array>();
    append_columns(array, static_cast<const double*>(array.data()), to);
  }
  return out;
}

template <class T>
[[nodiscard]] Column<T> word_column(const py::handle& item) {
  if (item.is_none()) return {};
  auto array = item.cast<py::array>();
  return column_of(array, static_cast<T*>(array.mutable_data()), 0);
}

void append_numbers(py::array array, Column<double>*& to) {
  append_columns(array, static_cast<double*>(array.mutable_data()), to);
}

/// status, verdict, overlap, normal, points, contact_point, iterations, evaluations, charts, each an array or None.
[[nodiscard]] ContactColumns contact_columns(const py::tuple& arrays) {
  constexpr std::array<std::size_t, 4> widths{1, 3, 6, 3};
  ContactColumns out{word_column<Status>(arrays[0]),
                     word_column<Verdict>(arrays[1]),
                     {},
                     {word_column<int>(arrays[6]), word_column<int>(arrays[7])},
                     {}};
  auto* to = out.numbers.data();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const py::object item = arrays[2 + i];
    if (item.is_none())
      to += widths[i];
    else
      append_numbers(item.cast<py::array>(), to);
  }
  auto* charts = out.charts.data();
  if (!arrays[8].is_none()) append_numbers(arrays[8].cast<py::array>(), charts);
  return out;
}

[[nodiscard]] ChartColumns<const double> last_columns(const py::object& last) {
  ChartColumns<const double> out;
  auto* to = out.data();
  if (last.is_none()) return out;
  const auto array = last.cast<py::array>();
  append_columns(array, static_cast<const double*>(array.data()), to);
  return out;
}

/// Whether no signal waits that Python would raise an exception for, as Ctrl-C does.
[[nodiscard]] bool no_signal() {
  const py::gil_scoped_acquire locked;
  return PyErr_CheckSignals() == 0;
}

[[nodiscard]] std::size_t solve_arrays(const py::tuple& body1, const py::tuple& body2, const py::tuple& contacts,
                                       const py::object& last, std::size_t size, const py::object& iteration_limit,
                                       const py::object& tolerance, const py::object& threads) {
  StridedBatch batch{size, body_columns(body1), body_columns(body2), contact_columns(contacts), {}, last_columns(last)};
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
