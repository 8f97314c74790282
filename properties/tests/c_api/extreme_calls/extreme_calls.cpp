// extreme_calls [COUNT [SEED]]: so many calls of plumb.h, and of the batch in each instruction set, with what no caller should
// pass: NaN, infinities, subnormals, exponents at 1 and at a million, arrays that are not there. For the sanitizers, vector code
// included, from the top folder (clang++-19; the million takes ten minutes of one core):
//
//   cmake --preset sanitizers -B build/sanitize -D CMAKE_CXX_COMPILER=clang++-19 -D CMAKE_C_COMPILER=clang-19 -D PLUMB_SANITIZE_BATCH=ON
//   ninja -C build/sanitize extreme_calls && build/sanitize/bin/extreme_calls 1000000
//
// Call i of a seed is the same whatever the count. Every buffer is of its own size to the byte. Exit code 1: an answer that is
// none, told with its call; a report of a sanitizer ends the program.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "properties/tests/c_api/owned_hull.hpp"
#include "properties/tests/extremes.hpp"
#include "solver/batch/batch.hpp"
#include "solver/c/door.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

constexpr std::array method_names{"auto",
                                  "original_cn",
                                  "corrected_cn",
                                  "new_cn",
                                  "minimum_distance",
                                  "geometric_potential",
                                  "geometric_potential_midway",
                                  "first_touch",
                                  "nobody"};

class Caller {
 public:
  explicit Caller(std::uint64_t seed) : draw_(seed) {}

  /// What is wrong with what came back; empty where nothing is.
  [[nodiscard]] std::string call() {
    switch (draw_.below(9)) {
      case 0: return describe();
      case 1: return batch();
      case 2: return batch_by_c();
      case 3: return door();
      case 4: return convex();
      default: return solve();
    }
  }

 private:
  [[nodiscard]] Pair any_pair() {
    Pair out = draw_.legal_pair();
    if (draw_.one_in(3)) draw_.spoil(draw_.one_in(2) ? out.body1 : out.body2);
    return out;
  }

  [[nodiscard]] plumb_options any_options() {
    plumb_options out = PLUMB_OPTIONS;
    if (!draw_.one_in(3)) out.method = method_names[draw_.below(method_names.size())];
    if (draw_.one_in(2)) out.want = static_cast<unsigned>(draw_.below(32));
    if (draw_.one_in(3)) out.iteration_limit = draw_.any_of({1, 2, 5, 14, 14, 40});
    if (draw_.one_in(50)) out.iteration_limit = draw_.any_of({1000, 1 << 30, 2147483647});
    if (draw_.one_in(3)) out.tolerance = draw_.power_of_ten(-20, 2);
    for (double& component : out.motion)
      if (draw_.one_in(3)) component = draw_.signed_of(draw_.power_of_ten(-300, 300));
    if (draw_.one_in(20)) spoil(out);
    return out;
  }

  void spoil(plumb_options& options) {
    switch (draw_.below(5)) {
      case 0: options.size = draw_.below(sizeof options + 1); return;
      case 1: options.want = static_cast<unsigned>(draw_.bits()); return;
      case 2: options.iteration_limit = -static_cast<int>(draw_.below(2)); return;
      case 3: options.tolerance = draw_.anything(); return;
      default: options.motion[draw_.below(3)] = draw_.anything();
    }
  }

  [[nodiscard]] std::string describe() {
    const plumb_pair pair = door::c_pair(any_pair());
    std::vector<char> text(draw_.one_in(4) ? draw_.below(4) : draw_.below(200));
    const int error = plumb_describe_input(draw_.one_in(50) ? nullptr : &pair, text.data(), text.size());
    if (error == PLUMB_OK && std::find(text.begin(), text.end(), '\0') == text.end()) return "a text without an end";
    (void)plumb_error_text(static_cast<int>(draw_.bits()));
    (void)plumb_status_name(static_cast<int>(draw_.bits()));
    (void)plumb_verdict_name(static_cast<int>(draw_.bits()));
    (void)plumb_method_name(draw_.below(20));
    return {};
  }

  /// Cold, and warm from its own end or from a context that holds anything.
  [[nodiscard]] std::string solve() {
    Pair bodies = any_pair();
    const plumb_options options = any_options();
    const auto context = std::make_unique<plumb_context>();
    if (draw_.one_in(4)) {
      for (double& number : context->state) number = draw_.anything();
      context->state[15] = draw_.one_in(2) ? 1 : 2;
    }
    std::string wrong = solve(bodies, options, draw_.one_in(3) ? nullptr : context.get());
    if (!wrong.empty() || draw_.one_in(2)) return wrong;
    bodies.body2.position *= draw_.uniform(0.9, 1.1);
    return solve(bodies, options, context.get());
  }

  [[nodiscard]] std::string solve(const Pair& bodies, const plumb_options& options, plumb_context* context) {
    const plumb_pair pair = door::c_pair(bodies);
    const std::size_t size = draw_.one_in(4) ? draw_.below(sizeof(plumb_details) + 1) : sizeof(plumb_details);
    const std::unique_ptr<void, void (*)(void*)> block(std::calloc(1, std::max(size, sizeof size)), std::free);
    auto* details = static_cast<plumb_details*>(block.get());
    details->size = size;
    plumb_contact contact{};
    const int error = plumb_solve(&pair, draw_.one_in(5) ? nullptr : &options, context, &contact,
                                  draw_.one_in(2) ? details : nullptr);
    return error == PLUMB_OK ? fault_of(contact) : std::string();
  }

  /// Of any points, some of them the same; null where one is not finite.
  [[nodiscard]] OwnedHull any_hull() {
    std::vector<double> points(3 * draw_.below(9));
    const double size = draw_.power_of_ten(-300, 300);
    for (double& x : points)
      x = draw_.one_in(50) ? draw_.anything() : size * draw_.any_of({-1.0, 0.0, 1.0, draw_.uniform(-1, 1)});
    int error = PLUMB_OK;
    return OwnedHull(plumb_hull_create(points.data(), points.size() / 3, draw_.one_in(2) ? &error : nullptr));
  }

  [[nodiscard]] plumb_convex_body any_convex_body(const plumb_hull* hull) {
    plumb_convex_body out{};
    out.shape.kind = draw_.one_in(50) ? static_cast<int>(draw_.bits()) : static_cast<int>(draw_.below(9));
    out.shape.hull = hull;
    const double size = draw_.one_in(2) ? 1 : draw_.power_of_ten(-300, 300);
    const bool has_exponents =
        out.shape.kind == PLUMB_SHAPE_SUPERELLIPSOID || out.shape.kind == PLUMB_SHAPE_POLY_SUPERELLIPSOID;
    for (double& x : out.shape.parameters) x = size * draw_.uniform(0.2, 1);
    const std::size_t exponents = out.shape.kind == PLUMB_SHAPE_SUPERELLIPSOID ? 3 : 6;
    for (std::size_t k = 0; k < 2 && has_exponents; ++k)
      out.shape.parameters[exponents + k] = draw_.any_of({1.001, 2.0, 8.0, 1e6});
    if (draw_.one_in(3)) out.swept_radius = size * draw_.uniform(0, 1);
    for (double& x : out.position) x = size * draw_.uniform(-1, 1);
    for (double& component : out.quaternion_wxyz) component = draw_.uniform(-1, 1);
    if (draw_.one_in(4)) out.shape.parameters[draw_.below(8)] = draw_.anything();
    if (draw_.one_in(10)) out.position[draw_.below(3)] = draw_.anything();
    return out;
  }

  [[nodiscard]] std::string convex() {
    const OwnedHull hull1 = any_hull(), hull2 = any_hull();
    const plumb_convex_pair pair{{any_convex_body(hull1.get()), any_convex_body(hull2.get())}};
    char text[100];
    (void)plumb_describe_convex_input(&pair, text, draw_.below(sizeof text + 1));
    const plumb_options options = any_options();
    plumb_context context{};
    plumb_contact contact{};
    plumb_details details{};
    details.size = draw_.below(sizeof details + 1);
    const int error =
        plumb_solve_convex_details(&pair, draw_.one_in(2) ? nullptr : &options, draw_.one_in(2) ? nullptr : &context,
                                   &contact, draw_.one_in(2) ? nullptr : &details);
    return error == PLUMB_OK ? fault_of(contact) : std::string();
  }

  [[nodiscard]] static std::string fault_of(const plumb_contact& c) {
    if (c.status < PLUMB_CONVERGED || c.status > PLUMB_INVALID_INPUT) return "a status that is none";
    if (c.verdict < PLUMB_UNDECIDED || c.verdict > PLUMB_SEPARATED) return "a verdict that is none";
    if (c.iterations < 0 || c.evaluations < 0) return "a count below zero";
    if (c.status != PLUMB_CONVERGED) return std::isnan(c.overlap) ? "" : "an overlap without convergence";
    const Vec3<double> n = Vec3<double>::Map(c.normal);
    if (!n.hasNaN() && !(std::abs(n.squaredNorm() - 1) < 1e-14)) return "a normal that is not of length 1";
    return std::isinf(c.overlap) ? "an overlap that is infinite" : "";
  }

  [[nodiscard]] std::string door() {
    const plumb_pair pair = door::c_pair(draw_.legal_pair());
    plumb_contact contact{}, next{};
    (void)plumb_solver_version();
    if (plumb_solver_solve(&pair, &contact) != 0) return "the door refused a legal pair";
    if (draw_.one_in(4))
      for (double& number : contact.points[draw_.below(2)]) number = draw_.anything();
    return plumb_solver_solve_warm(&pair, &contact, &next) == 0 ? "" : "the warm door refused a legal pair";
  }

  /// n pairs in columns of their own, 24 of them.
  struct Columns {
    std::vector<std::vector<double>> of;

    [[nodiscard]] plumb_body_arrays c_arrays(std::size_t body) const {
      plumb_body_arrays out{};
      const auto at = [&](std::size_t k) { return of[12 * body + k].data(); };
      for (std::size_t k = 0; k < 3; ++k) out.semi_axes[k] = at(k), out.position[k] = at(5 + k);
      for (std::size_t k = 0; k < 2; ++k) out.exponents[k] = at(3 + k);
      for (std::size_t k = 0; k < 4; ++k) out.quaternion_wxyz[k] = at(8 + k);
      return out;
    }
    [[nodiscard]] BodyArrays arrays(std::size_t body) const {
      const auto at = [&](std::size_t k) { return std::span<const double>(of[12 * body + k]); };
      return {{at(0), at(1), at(2)}, at(3), at(4), {at(5), at(6), at(7)}, {at(8), at(9), at(10), at(11)}};
    }
  };

  /// Of a batch: mostly a few pairs, one in eight up to more than a chunk.
  [[nodiscard]] std::size_t any_count() { return draw_.below(draw_.one_in(8) ? 71 : 7); }

  [[nodiscard]] Columns any_columns(std::size_t n) {
    Columns out{std::vector<std::vector<double>>(24)};
    const bool are_ellipsoids = draw_.one_in(3);
    for (std::size_t i = 0; i < n; ++i) {
      Pair pair = draw_.one_in(3) ? draw_.ellipsoids(draw_.power_of_ten(-3, 308)) : any_pair();
      for (Body* body : {&pair.body1, &pair.body2})
        if (are_ellipsoids) body->shape.n1 = body->shape.n2 = 2;
      append(pair.body1, out, 0);
      append(pair.body2, out, 12);
    }
    return out;
  }

  static void append(const Body& body, Columns& to, std::size_t first) {
    const auto &a = body.shape.semi_axes, &x = body.position;
    const auto& q = body.quaternion;
    for (const double value :
         {a[0], a[1], a[2], body.shape.n1, body.shape.n2, x[0], x[1], x[2], q[0], q[1], q[2], q[3]})
      to.of[first++].push_back(value);
  }

  [[nodiscard]] std::vector<double> column(std::size_t n) { return std::vector<double>(draw_.one_in(4) ? 0 : n); }

  [[nodiscard]] std::string batch() {
    const std::size_t n = any_count();
    const Columns columns = any_columns(n);
    const bool is_wide = draw_.one_in(2) && is_available(InstructionSet::avx2);
    std::vector<Status> status(n);
    std::array<std::vector<double>, 13> to;
    for (auto& one : to) one = column(n);
    std::vector<int> iterations(draw_.one_in(2) ? n : 0);
    const ContactArrays contacts{.status = status,
                                 .overlap = to[0],
                                 .normal = {to[1], to[2], to[3]},
                                 .point1 = {to[4], to[5], to[6]},
                                 .point2 = {to[7], to[8], to[9]},
                                 .contact_point = {to[10], to[11], to[12]},
                                 .iterations = iterations};
    Want want;
    if (draw_.one_in(3)) want.iteration_limit = draw_.any_of({1, 5, 14, 1 << 30});
    if (draw_.one_in(3)) want.tolerance = draw_.power_of_ten(-20, 2);
    const BatchReport report = solve_batch({columns.arrays(0), columns.arrays(1)}, want, contacts,
                                           is_wide ? InstructionSet::avx2 : InstructionSet::baseline);
    return report.error == BatchError::none ? fault_of(status, to[0]) : "the batch refused arrays of one length";
  }

  template <class S>
  [[nodiscard]] static std::string fault_of(const std::vector<S>& status, const std::vector<double>& overlap) {
    for (std::size_t i = 0; i < overlap.size(); ++i) {
      const bool converged = static_cast<int>(status[i]) == PLUMB_CONVERGED;
      if (converged ? !std::isfinite(overlap[i]) : !std::isnan(overlap[i]))
        return "an overlap of " + std::to_string(overlap[i]);
    }
    return {};
  }

  [[nodiscard]] std::string batch_by_c() {
    const std::size_t n = any_count();
    const Columns columns = any_columns(n);
    plumb_body_arrays bodies[2] = {columns.c_arrays(0), columns.c_arrays(1)};
    plumb_body_arrays& one = bodies[draw_.below(2)];
    if (draw_.one_in(4)) one.exponents[0] = one.exponents[1] = nullptr;
    if (draw_.one_in(20)) one.position[draw_.below(3)] = nullptr;
    std::vector<int> status(n);
    std::array<std::vector<double>, 4> to;
    for (auto& values : to) values = column(n);
    plumb_contact_arrays contacts{};
    contacts.status = status.data();
    const auto data_of = [](std::vector<double>& values) { return values.empty() ? nullptr : values.data(); };
    contacts.overlap = data_of(to[0]);
    contacts.normal[draw_.below(3)] = data_of(to[1]);
    contacts.points[draw_.below(2)][draw_.below(3)] = data_of(to[2]);
    contacts.contact_point[draw_.below(3)] = data_of(to[3]);
    plumb_options options = any_options();
    if (!draw_.one_in(10)) options.method = nullptr;
    const int error = plumb_solve_batch(n, bodies, draw_.one_in(3) ? nullptr : &options, &contacts);
    return error == PLUMB_OK ? fault_of(status, to[0]) : std::string();
  }

  Extremes draw_;
};

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  const auto number = [&](int i, std::uint64_t otherwise) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  const std::uint64_t count = number(1, 3000), seed = number(2, 1);
  int faults = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string wrong = plumb::Caller((seed << 40U) + i).call();
    if (wrong.empty()) continue;
    ++faults;
    (void)std::fprintf(stderr, "call %llu of seed %llu: %s\n", static_cast<unsigned long long>(i),
                       static_cast<unsigned long long>(seed), wrong.c_str());
  }
  (void)std::printf("%llu calls, %d faults\n", static_cast<unsigned long long>(count), faults);
  return faults == 0 ? 0 : 1;
}
