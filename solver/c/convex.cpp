// The C API's convex shapes: plumb_solve_convex and what goes into it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include "solver/c/contexts.hpp"
#include "solver/c/convex_door.hpp"
#include "solver/c/details.hpp"
#include "solver/c/door.hpp"
#include "solver/c/options.hpp"
#include "solver/c/texts.hpp"
#include "solver/method/convex.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

Contact<double> solve(const plumb_convex_pair& pair, const Want& want, const Contact<double>* last) {
  if (door::error_in_shapes(pair).reason.empty()) return solve_convex(door::pair_of(pair), want, last);
  Contact<double> refused;
  refused.status = Status::invalid_input;
  return refused;
}

bool are_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

plumb_hull* hull_of(std::span<const double> numbers) {
  std::vector<Vec3<double>> points;
  points.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(Vec3<double>::Map(&numbers[i]));
  return std::make_unique<plumb_hull>(plumb_hull{make_polyhedron(points)}).release();
}

/// Writes the hull, or says why not.
int make_hull(const double* points, std::size_t count, plumb_hull*& out) {
  constexpr std::size_t most = std::numeric_limits<int>::max();  // by which a hull numbers its corners
  if (points == nullptr || count == 0 || count > most || !are_finite({points, 3 * count})) return PLUMB_ERROR_ARGUMENT;
  try {
    out = hull_of({points, 3 * count});
    return PLUMB_OK;
  } catch (const std::bad_alloc&) {
    return PLUMB_ERROR_MEMORY;
  } catch (...) {
    return PLUMB_ERROR_INTERNAL;
  }
}

}  // namespace
}  // namespace plumb

using namespace plumb;

extern "C" {

plumb_hull* plumb_hull_create(const double* points, size_t count, int* error) {
  const StandardArithmetic mode;
  plumb_hull* out = nullptr;
  const int found = make_hull(points, count, out);
  if (error != nullptr) *error = found;
  return out;
}

void plumb_hull_destroy(plumb_hull* hull) {
  delete hull;
}

int plumb_describe_convex_input(const plumb_convex_pair* pair, char* text, size_t size) {
  if (pair == nullptr || text == nullptr || size == 0) return PLUMB_ERROR_ARGUMENT;
  InputError error = door::error_in_shapes(*pair);
  if (error.reason.empty()) error = find_input_error(door::pair_of(*pair));
  if (error.reason.empty()) error = find_foreign_error(door::pair_of(*pair));
  write_text(error, {text, size});
  return PLUMB_OK;
}

int plumb_solve_convex(const plumb_convex_pair* pair, const plumb_options* options, plumb_context* context,
                       plumb_contact* contact) {
  return plumb_solve_convex_details(pair, options, context, contact, nullptr);
}

int plumb_solve_convex_details(const plumb_convex_pair* pair, const plumb_options* options, plumb_context* context,
                               plumb_contact* contact, plumb_details* details) {
  const StandardArithmetic mode;
  const plumb_options chosen = options_of(options);
  if (pair == nullptr || contact == nullptr || !are_legal(chosen) || !are_legal(details)) return PLUMB_ERROR_ARGUMENT;
  if (!is_auto(chosen)) return PLUMB_ERROR_METHOD;
  const std::optional<Contact<double>> last = last_of(context);
  const Contact<double> found = solve(*pair, want_of(chosen), last ? &*last : nullptr);
  *contact = door::c_contact(found);
  if (context != nullptr) keep(found, *context);
  if (details != nullptr) write_details(found, *details);
  return PLUMB_OK;
}

}  // extern "C"
