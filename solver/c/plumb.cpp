// The C API, plumb.h, but for certificates. Thin: what is solved, and how, is the library's.
#include "solver/plumb.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "solver/batch/batch.hpp"
#include "solver/batch/chunk.hpp"
#include "solver/c/auto_door.hpp"
#include "solver/c/contexts.hpp"
#include "solver/c/details.hpp"
#include "solver/c/options.hpp"
#include "solver/c/texts.hpp"
#include "solver/method/methods.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

/// `length` entries of an array, or none where there is no array.
template <class T>
std::span<T> part(T* array, std::size_t begin, std::size_t length) {
  return array == nullptr ? std::span<T>() : std::span<T>(array + begin, length);
}

template <std::size_t N>
std::array<std::span<const double>, N> parts(const double* const (&arrays)[N], std::size_t begin, std::size_t length) {
  std::array<std::span<const double>, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = part(arrays[i], begin, length);
  return out;
}

std::array<std::span<double>, 3> parts(double* const (&arrays)[3], std::size_t begin, std::size_t length) {
  return {part(arrays[0], begin, length), part(arrays[1], begin, length), part(arrays[2], begin, length)};
}

BodyArrays body_part(const plumb_body_arrays& body, std::size_t begin, std::size_t length) {
  return {parts(body.semi_axes, begin, length), part(body.exponents[0], begin, length),
          part(body.exponents[1], begin, length), parts(body.position, begin, length),
          parts(body.quaternion_wxyz, begin, length)};
}

/// Status and Verdict are written here first: to C they are int.
struct Codes {
  static constexpr std::size_t length = 64;
  std::array<Status, length> status;
  std::array<Verdict, length> verdict;

  void copy_to(const plumb_contact_arrays& contacts, std::size_t begin, std::size_t count) const {
    for (std::size_t i = 0; contacts.status != nullptr && i < count; ++i)
      contacts.status[begin + i] = static_cast<int>(status[i]);
    for (std::size_t i = 0; contacts.verdict != nullptr && i < count; ++i)
      contacts.verdict[begin + i] = static_cast<int>(verdict[i]);
  }
};

ContactArrays contact_part(const plumb_contact_arrays& contacts, Codes& codes, std::size_t begin, std::size_t length) {
  return {.status = part(contacts.status != nullptr ? codes.status.data() : nullptr, 0, length),
          .verdict = part(contacts.verdict != nullptr ? codes.verdict.data() : nullptr, 0, length),
          .overlap = part(contacts.overlap, begin, length),
          .normal = parts(contacts.normal, begin, length),
          .point1 = parts(contacts.points[0], begin, length),
          .point2 = parts(contacts.points[1], begin, length),
          .contact_point = parts(contacts.contact_point, begin, length),
          .iterations = part(contacts.iterations, begin, length),
          .evaluations = part(contacts.evaluations, begin, length)};
}

Body body_at(const plumb_body_arrays& from, std::size_t i) {
  const auto vector = [&](const auto& arrays) { return Vec3<double>(arrays[0][i], arrays[1][i], arrays[2][i]); };
  const auto exponent = [&](const double* array) { return array == nullptr ? 2 : array[i]; };
  const auto& q = from.quaternion_wxyz;
  return {{vector(from.semi_axes), exponent(from.exponents[0]), exponent(from.exponents[1])},
          vector(from.position),
          {q[0][i], q[1][i], q[2][i], q[3][i]}};
}

void write_contact(const Contact<double>& found, const plumb_contact_arrays& to, std::size_t i) {
  const auto write = [&](auto* array, auto value) {
    if (array != nullptr) array[i] = value;
  };
  const auto write_vector = [&](double* const(&arrays)[3], const Vec3<double>& value) {
    for (int k = 0; k < 3; ++k) write(arrays[k], value[k]);
  };
  write(to.status, static_cast<int>(found.status));
  write(to.verdict, static_cast<int>(found.verdict));
  write(to.overlap, found.overlap);
  write_vector(to.normal, found.normal);
  write_vector(to.points[0], found.point1);
  write_vector(to.points[1], found.point2);
  write_vector(to.contact_point, found.contact_point);
  write(to.iterations, found.iterations);
  write(to.evaluations, found.evaluations);
}

template <std::size_t N>
bool are_all(const double* const (&arrays)[N], bool there) {
  for (const double* array : arrays)
    if ((array != nullptr) != there) return false;
  return true;
}

bool is_complete(const plumb_body_arrays& body) {
  return are_all(body.semi_axes, true) && are_all(body.position, true) && are_all(body.quaternion_wxyz, true) &&
         (are_all(body.exponents, true) || are_all(body.exponents, false));
}

/// What the arrays ask for.
Want wants_of(Want want, const plumb_contact_arrays& to) {
  const auto is_any = [](double* const(&arrays)[3]) {
    return arrays[0] != nullptr || arrays[1] != nullptr || arrays[2] != nullptr;
  };
  want.overlap = to.overlap != nullptr;
  want.normal = is_any(to.normal);
  want.points = is_any(to.points[0]) || is_any(to.points[1]) || is_any(to.contact_point);
  want.curvature = want.derivatives = want.patch = false;
  return want;
}

/// All parts of n pairs in turn: work(first pair, pairs).
template <class Work>
int each_part(std::size_t n, const Work& work) {
  for (std::size_t begin = 0; begin < n; begin += Codes::length)
    if (!work(begin, std::min(Codes::length, n - begin))) return PLUMB_ERROR_ARGUMENT;
  return PLUMB_OK;
}

int solve_cold(std::size_t n, const plumb_body_arrays bodies[2], const Want& want,
               const plumb_contact_arrays& contacts) {
  Codes codes;
  return each_part(n, [&](std::size_t begin, std::size_t length) {
    const PairArrays pairs{body_part(bodies[0], begin, length), body_part(bodies[1], begin, length)};
    const BatchReport report = solve_batch(pairs, want, contact_part(contacts, codes, begin, length));
    codes.copy_to(contacts, begin, length);
    return report.error == BatchError::none;
  });
}

/// A part side by side, and their contexts; not inlined, so that all columns are off the stack before a search.
[[nodiscard, gnu::noinline]] Unsettled solve_together(const plumb_body_arrays bodies[2], const Want& want,
                                                      std::span<plumb_context> contexts,
                                                      const plumb_contact_arrays& contacts, std::size_t begin) {
  const std::size_t length = contexts.size();
  Codes codes;
  ContextColumns<Codes::length> charts;
  charts.load(contexts);
  ContactArrays to = contact_part(contacts, codes, begin, length);
  charts.set_outputs(to, length);
  const PairArrays pairs{body_part(bodies[0], begin, length), body_part(bodies[1], begin, length), charts.last(length),
                         charts.before_last(length), charts.bends(length)};
  const Unsettled unsettled = solve_together({pairs, want, to, 0, length}, InstructionSet::best);
  charts.store(unsettled, contexts);
  codes.copy_to(contacts, begin, length);
  return unsettled;
}

/// One that is left. Not inlined: a cold batch has no room for its contacts on the stack.
[[gnu::noinline]] void solve_alone(const plumb_body_arrays bodies[2], const Want& want, plumb_context& context,
                                   const plumb_contact_arrays& contacts, std::size_t i) {
  const std::optional<Contact<double>> last = last_of(&context);
  const Pair pair{body_at(bodies[0], i), body_at(bodies[1], i)};
  const Contact<double> found = find_method("auto")->solve(pair, want, last ? &*last : nullptr);
  write_contact(found, contacts, i);
  keep(found, context);
}

int solve_warm(std::size_t n, const plumb_body_arrays bodies[2], const Want& want, plumb_context* contexts,
               const plumb_contact_arrays& contacts) {
  return each_part(n, [&](std::size_t begin, std::size_t length) {
    const Unsettled left = solve_together(bodies, want, {contexts + begin, length}, contacts, begin);
    each_unsettled(left, [&](std::size_t k) { solve_alone(bodies, want, contexts[begin + k], contacts, begin + k); });
    return true;
  });
}

}  // namespace
}  // namespace plumb

using namespace plumb;

extern "C" {

const char* plumb_version(void) {
  return PLUMB_LIBRARY_VERSION;
}

const char* plumb_error_text(int error) {
  switch (error) {
    case PLUMB_ERROR_ARGUMENT: return "an argument is null or out of its range";
    case PLUMB_ERROR_METHOD: return "there is no such method";
    case PLUMB_ERROR_MEMORY: return "out of memory";
    case PLUMB_ERROR_INTERNAL: return "a library under plumb failed";
    default: return "";
  }
}

const char* plumb_status_name(int status) {
  const bool is_one = status >= PLUMB_CONVERGED && status <= PLUMB_INVALID_INPUT;
  return is_one ? c_text(name(static_cast<Status>(status))) : "";
}

const char* plumb_verdict_name(int verdict) {
  const bool is_one = verdict >= PLUMB_UNDECIDED && verdict <= PLUMB_SEPARATED;
  return is_one ? c_text(name(static_cast<Verdict>(verdict))) : "";
}

const char* plumb_method_name(size_t index) {
  return index < methods().size() ? c_text(methods()[index].name) : nullptr;
}

int plumb_describe_input(const plumb_pair* pair, char* text, size_t size) {
  if (pair == nullptr || text == nullptr || size == 0) return PLUMB_ERROR_ARGUMENT;
  write_text(find_input_error(door::pair_of(*pair)), {text, size});
  return PLUMB_OK;
}

int plumb_solve(const plumb_pair* pair, const plumb_options* options, plumb_context* context, plumb_contact* contact,
                plumb_details* details) {
  const StandardArithmetic mode;
  const plumb_options chosen = options_of(options);
  if (pair == nullptr || contact == nullptr || !are_legal(chosen)) return PLUMB_ERROR_ARGUMENT;
  if (!are_legal(details)) return PLUMB_ERROR_ARGUMENT;
  const Method* method = find_method(chosen.method == nullptr ? "auto" : chosen.method);
  if (method == nullptr) return PLUMB_ERROR_METHOD;
  Pair bodies = door::pair_of(*pair);
  bodies.motion = Vec3<double>::Map(chosen.motion);
  std::optional<Contact<double>> last = last_of(context);
  if (last) take_witnesses(*last, chosen.witnesses);
  const Contact<double> found = method->solve(bodies, want_of(chosen), last ? &*last : nullptr);
  *contact = door::c_contact(found);
  if (context != nullptr) keep(found, *context);
  if (context != nullptr && is_auto(chosen)) keep(found.witnesses, chosen.witnesses);
  if (details != nullptr) write_details(found, *details);
  return PLUMB_OK;
}

int plumb_solve_batch(size_t n, const plumb_body_arrays bodies[2], const plumb_options* options,
                      const plumb_contact_arrays* contacts) {
  return plumb_solve_batch_warm(n, bodies, options, nullptr, contacts);
}

int plumb_solve_batch_warm(size_t n, const plumb_body_arrays bodies[2], const plumb_options* options,
                           plumb_context* contexts, const plumb_contact_arrays* contacts) {
  const StandardArithmetic mode;
  const plumb_options chosen = options_of(options);
  if (bodies == nullptr || contacts == nullptr || !are_legal(chosen)) return PLUMB_ERROR_ARGUMENT;
  if (n > 0 && !(is_complete(bodies[0]) && is_complete(bodies[1]))) return PLUMB_ERROR_ARGUMENT;
  if (!is_auto(chosen)) return PLUMB_ERROR_METHOD;
  return contexts == nullptr ? solve_cold(n, bodies, want_of(chosen), *contacts)
                             : solve_warm(n, bodies, wants_of(want_of(chosen), *contacts), contexts, *contacts);
}

// The library is itself a solver behind the C door: plumb campaign --solver libplumb.so.
PLUMB_API int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION;
}

PLUMB_API int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return door::solve(*pair, *contact);
}

PLUMB_API int plumb_solver_solve_warm(const plumb_pair* pair, const plumb_contact* last, plumb_contact* contact) {
  return door::solve_warm(*pair, *last, *contact);
}

}  // extern "C"
