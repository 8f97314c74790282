// The loader of shared libraries that implement solver/plumb_solver.h: foreign ones by their path, the peers by their name.
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "corpus/case.hpp"
#include "corpus/program_folder.hpp"
#include "corpus/solver.hpp"
#include "solver/plumb_solver.h"

namespace plumb {
namespace {

struct Library {
  std::string name;
  decltype(&plumb_solver_solve) solve;
};

plumb_body body_of(const Body& body) {
  const Superellipsoid<double>& shape = body.shape;
  plumb_body out{};
  std::copy_n(shape.semi_axes.data(), 3, out.semi_axes);
  out.exponents[0] = shape.n1;
  out.exponents[1] = shape.n2;
  std::copy_n(body.position.data(), 3, out.position);
  std::copy_n(body.quaternion.data(), 4, out.quaternion_wxyz);
  return out;
}

Vec3<double> vector_of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

// The library may write any integer; what is no status vouches for nothing.
Status status_of(int status) {
  switch (status) {
    case PLUMB_CONVERGED: return Status::converged;
    case PLUMB_ITERATION_LIMIT: return Status::iteration_limit;
    case PLUMB_SINGULAR: return Status::singular;
    case PLUMB_NOT_FINITE: return Status::not_finite;
    case PLUMB_INVALID_INPUT: return Status::invalid_input;
    default: return Status::stalled;
  }
}

Verdict read_verdict(int verdict) {
  if (verdict == PLUMB_OVERLAPPING) return Verdict::overlapping;
  return verdict == PLUMB_SEPARATED ? Verdict::separated : Verdict::undecided;
}

plumb_contact silent_contact() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      PLUMB_STALLED, PLUMB_UNDECIDED, nan, {nan, nan, nan}, {{nan, nan, nan}, {nan, nan, nan}}, {nan, nan, nan}, 0, 0};
}

Contact<double> contact_of(const plumb_contact& answer) {
  Contact<double> out;
  out.status = status_of(answer.status);
  out.verdict = read_verdict(answer.verdict);
  out.overlap = answer.overlap;
  out.normal = vector_of(answer.normal);
  out.point1 = vector_of(answer.points[0]);
  out.point2 = vector_of(answer.points[1]);
  out.contact_point = vector_of(answer.contact_point);
  out.iterations = answer.iterations;
  out.evaluations = answer.evaluations;
  return out;
}

Contact<double> solve_with(const Library& library, const Pair& pair) {
  const plumb_pair input{{body_of(pair.body1), body_of(pair.body2)}};
  plumb_contact answer = silent_contact();
  const bool refused = library.solve(&input, &answer) != 0;
  Contact<double> out = refused ? Contact<double>{} : contact_of(answer);
  if (refused) out.status = Status::invalid_input;
  out.method = library.name;
  return out;
}

template <class Function>
Function symbol(void* handle, const std::string& path, const char* name) {
  void* address = dlsym(handle, name);
  if (address == nullptr) throw InputFailure(path, 0, name, "not exported by the library (see solver/plumb_solver.h)");
  return reinterpret_cast<Function>(address);
}

void require_version(void* handle, const std::string& path) {
  const int version = symbol<decltype(&plumb_solver_version)>(handle, path, "plumb_solver_version")();
  if (version == PLUMB_SOLVER_VERSION) return;
  throw InputFailure(path, 0, "plumb_solver_version",
                     "is " + std::to_string(version) + ", must be " + std::to_string(PLUMB_SOLVER_VERSION));
}

// Without a slash dlopen would look in the system's folders and not here.
void* open_library(const std::string& path) {
  const std::string name = path.find('/') == std::string::npos ? "./" + path : path;
  void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw InputFailure(path, 0, "", std::string("cannot be loaded: ") + dlerror());
  return handle;
}

// The library stays loaded until the process ends: what it registered with the system may outlive any owner of ours.
Solver load(const std::string& path, const std::string& name, const std::string& summary) {
  void* handle = open_library(path);
  require_version(handle, path);
  const auto solve = symbol<decltype(&plumb_solver_solve)>(handle, path, "plumb_solver_solve");
  const auto library = std::make_shared<const Library>(Library{name, solve});
  return {
      name,    Problem::common_normal,
      summary, false,
      false,   [library](const Pair& pair, const Want&, const Contact<double>*) { return solve_with(*library, pair); }};
}

struct Peer {
  std::string_view name, summary;
};
constexpr std::array<Peer, 3> kPeers{{
    {"peer_libccd_epa", "libccd's GJK and EPA, tolerance 1e-12; bodies apart: the verdict alone"},
    {"peer_libccd_mpr", "libccd's MPR, tolerance 1e-12: a depth, not the lowest; apart: the verdict alone"},
    {"peer_fcl", "FCL's signed distance of ellipsoids, tolerance 1e-6; refuses other exponents"},
}};

std::string peer_path(std::string_view name) {
  return program_folder() / "peers" / (std::string(name) + ".so");
}

}  // namespace

Solver load_solver(const std::string& path) {
  return load(path, "solver:" + std::filesystem::path(path).filename().string(), "foreign solver " + path);
}

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const Peer& peer : kPeers)
    if (std::filesystem::exists(peer_path(peer.name))) names.emplace_back(peer.name);
  return names;
}

Solver load_peer(const std::string& name) {
  const auto peer = std::find_if(kPeers.begin(), kPeers.end(), [&](const Peer& p) { return p.name == name; });
  if (peer == kPeers.end()) throw InputFailure("--method", 0, name, "no such peer");
  Solver solver = load(peer_path(name), name, std::string(peer->summary));
  solver.published = true;
  return solver;
}

}  // namespace plumb
