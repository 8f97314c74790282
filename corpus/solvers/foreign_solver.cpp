// Foreign solvers: by the path of their library, which implements solver/plumb_solver.h, by a command, the peers by their name.
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>

#include "corpus/case/case.hpp"
#include "corpus/command/program_folder.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "corpus/solvers/solver.hpp"
#include "corpus/solvers/solver_library.hpp"
#include "corpus/solvers/solver_pool.hpp"
#include "solver/c/door.hpp"

namespace plumb {
namespace {

/// `refused`: it wrote nothing that counts. `name` outlives the answer.
Contact<double> contact_of(bool refused, const plumb_contact& answer, const std::string& name) {
  Contact<double> out = refused ? Contact<double>{} : door::contact_of(answer);
  if (refused) out.status = Status::invalid_input;
  out.method = name;
  return out;
}

TimedContact ask_pool(SolverPool& pool, const Pair& pair, const Contact<double>* last) {
  wire::Request request;
  request.pair = door::c_pair(pair);
  if (last != nullptr) {
    request.kind = wire::Request::Kind::solve_warm;
    request.last = door::c_contact(*last);
  }
  const wire::Reply reply = pool.ask(request);
  return {contact_of(reply.kind == wire::Reply::Kind::refused, reply.contact, pool.name()), reply.nanoseconds};
}

struct InProcess {
  std::string name;
  SolverLibrary library;
};

Contact<double> ask_in_process(const InProcess& solver, const Pair& pair, const Contact<double>* last) {
  const plumb_pair input = door::c_pair(pair);
  const plumb_contact start = last == nullptr ? silent_contact() : door::c_contact(*last);
  plumb_contact answer{};
  const int refused = ask(solver.library, input, last == nullptr ? nullptr : &start, answer);
  return contact_of(refused != 0, answer, solver.name);
}

/// The words of the door are in the order of ours.
Abilities abilities_of(const wire::Hello& hello, const std::string& path) {
  const plumb_abilities& said = hello.abilities;
  Abilities out{hello.name.text(), hello.version.text(), hello.licence.text()};
  if (const std::string wrong = refuse_solver_name(out.name); !out.name.empty() && !wrong.empty())
    throw InputFailure(path, 0, "plumb_solver_abilities: name", wrong);
  out.shapes = static_cast<Shapes>(said.shapes);
  out.exponents = {said.exponents[0], said.exponents[1]};
  out.apart = static_cast<Apart>(said.apart);
  out.points = static_cast<Points>(said.points);
  out.normal = said.normal != 0;
  out.warm = hello.warm;
  out.problem = static_cast<Problem>(said.problem);
  out.tolerance = said.tolerance;
  return out;
}

/// `file`: the library, or the program.
std::string foreign_name(const std::string& file, const Abilities& abilities) {
  return "solver:" + (abilities.name.empty() ? std::filesystem::path(file).filename().string() : abilities.name);
}

std::string option_of(const SolverSource& source) {
  if (source.is_command()) return " --solver-command " + shell_word(source.text);
  return " --solver " + shell_word(std::filesystem::absolute(source.text).lexically_normal().string());
}

/// `name`: empty for what it calls itself.
Solver solver_over(const std::string& name, const SolverSource& source, const SolverLimits& limits,
                   std::string summary) {
  const auto pool = std::make_shared<SolverPool>(source, limits);
  const Abilities abilities = abilities_of(pool->start(), source.text);
  const std::string& file = source.is_command() ? source.words.front() : source.text;
  pool->call(name.empty() ? foreign_name(file, abilities) : name);
  return {pool->name(),
          abilities,
          std::move(summary),
          false,
          false,
          [pool](const Pair& pair, const Want&, const Contact<double>* last) {
            return ask_pool(*pool, pair, last).contact;
          },
          option_of(source),
          pool};
}

Solver load_here(const std::string& path, const std::string& name, const std::string& summary) try {
  const auto solver = std::make_shared<InProcess>(InProcess{name, open_solver_library(path)});
  wire::Hello hello;
  introduce(hello, solver->library);
  const Abilities abilities = abilities_of(hello, path);
  if (name.empty()) solver->name = foreign_name(path, abilities);
  return {solver->name,
          abilities,
          summary,
          false,
          false,
          [solver](const Pair& pair, const Want&, const Contact<double>* last) {
            return ask_in_process(*solver, pair, last);
          },
          option_of({path})};
} catch (const UnusableLibrary& e) {
  throw InputFailure(path, 0, e.field, e.what());
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

Solver load_solver(const std::string& path, const SolverLimits& limits) {
  return solver_over("", {path}, limits, "foreign solver " + path);
}

Solver load_solver_command(const std::string& command, const SolverLimits& limits) {
  return solver_over("", {command, split_command(command)}, limits, "foreign solver " + command);
}

Solver load_solver_in_process(const std::string& path) {
  return load_here(path, "", "foreign solver " + path);
}

Solver in_process(const Solver& solver) {
  if (!solver.pool || solver.pool->source().is_command()) return solver;
  Solver here = load_here(solver.pool->source().text, solver.name, solver.summary);
  here.published = solver.published;
  here.option = solver.option;
  return here;
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
  Solver solver = solver_over(name, {peer_path(name)}, SolverLimits{}, std::string(peer->summary));
  solver.published = true;
  solver.option.clear();  // its name is enough
  return solver;
}

namespace {

template <class Solve>
TimedContact timed(const Solve& solve) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  TimedContact out{solve()};
  out.nanoseconds = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  return out;
}

}  // namespace

TimedContact solve_timed(const Solver& solver, const Pair& pair, const Want& want, const Contact<double>* last) {
  if (solver.pool) return ask_pool(*solver.pool, pair, last);
  return timed([&] { return solver.solve(pair, want, last); });
}

TimedContact solve_timed(const Solver& solver, const ConvexPair& pair, const Want& want, const Contact<double>* last) {
  return timed([&] { return solver.solve_convex(pair, want, last); });
}

bool is_given_up(const Solver& solver) {
  return solver.pool && solver.pool->hangs() >= most_hangs;
}

std::optional<Leak> find_leak(const Solver& solver, std::span<const Pair> pairs) {
  if (!solver.pool) return std::nullopt;
  std::vector<plumb_pair> asked;
  for (const Pair& pair : pairs) asked.push_back(door::c_pair(pair));
  return solver.pool->find_leak(std::move(asked));
}

}  // namespace plumb
