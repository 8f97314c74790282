// A foreign solver that does what the environment variable PLUMB_MISBEHAVIOUR says; refuses every pair otherwise.
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/solvers/solver_wire.hpp"

// A solver that is right, for spheres.
#define plumb_solver_version spheres_version
#define plumb_solver_solve solve_spheres
#include "fuzz/example/bounding_spheres.c"
#undef plumb_solver_version
#undef plumb_solver_solve

namespace {

int calls = 0;

int deeper(volatile const char* above, int more) {
  std::array<volatile char, 4096> here{};
  here[0] = above[0];
  return more == 0 ? 0 : deeper(here.data(), more - 1) + here[0];
}

int say_apart(plumb_contact* contact) {
  contact->status = PLUMB_CONVERGED;
  contact->verdict = PLUMB_SEPARATED;
  contact->overlap = -1;
  for (auto* v : {contact->normal, contact->points[0], contact->points[1]}) v[0] = v[1] = v[2] = 0;
  contact->normal[0] = 1;
  return 0;
}

int crash() {
  (void)std::raise(SIGSEGV);
  return 1;
}

int waver(const plumb_pair& pair, plumb_contact* contact) {
  const int refused = solve_spheres(&pair, contact);
  contact->evaluations = calls;
  return refused;
}

int say_and_abort() {
  (void)std::fputs("out of 0x1234 ideas\n", stderr);
  std::abort();
}

int leak() {
  volatile char* lost = static_cast<char*>(std::malloc(64));
  lost[0] = 1;
  return 1;
}

int leak_pages() {
  volatile char* lost =
      static_cast<char*>(mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  lost[0] = 1;
  return 1;
}

/// Takes memory for its first 300 calls, and keeps it.
int cache() {
  return calls <= 300 ? leak() : 1;
}

int print() {
  for (int i = 0; i < 3000; ++i) std::puts("a solver that talks, and talks");
  std::fputs("and talks\n", stderr);
  return 1;
}

int leave() {
  std::exit(0);
}

int hang() {
  volatile bool forever = true;
  while (forever) continue;
  return 1;
}

int fall_asleep() {
  for (;;) pause();
}

int shut_the_door() {
  for (int number = 3; number < 64; ++number) (void)close(number);
  return 1;
}

/// Comes back in two processes.
int come_back_twice(const plumb_pair& pair, plumb_contact* contact) {
  (void)fork();
  return solve_spheres(&pair, contact);
}

/// Another answer, before the one that it returns, through every socket that it finds.
int forge(const plumb_pair& pair, plumb_contact* contact) {
  const plumb::wire::Reply forged;
  for (int number = 3; number < 64; ++number) (void)send(number, &forged, sizeof forged, MSG_NOSIGNAL | MSG_DONTWAIT);
  return solve_spheres(&pair, contact);
}

/// Half a gigabyte, and then no answer.
int take_all_memory() {
  std::vector<std::vector<char>> taken;
  for (int i = 0; i < 512; ++i) taken.emplace_back(1 << 20, 'x');
  return hang();
}

/// As much again with each call.
int take_more_memory(const plumb_pair& pair, plumb_contact* contact) {
  static std::vector<std::vector<char>> taken;
  taken.emplace_back(1 << 23, 'x');
  return solve_spheres(&pair, contact);
}

int kill_the_caller(int signal, const plumb_pair& pair, plumb_contact* contact) {
  (void)kill(getppid(), signal);
  return solve_spheres(&pair, contact);
}

/// Signal 0 asks for the permission alone.
int reach_everybody(const plumb_pair& pair, plumb_contact* contact) {
  return kill(-1, 0) == 0 || errno != EPERM ? crash() : solve_spheres(&pair, contact);
}

int misbehave(std::string_view how, const plumb_pair& pair, plumb_contact* contact) {
  const bool to_the_right = pair.bodies[1].position[0] > pair.bodies[0].position[0];
  const std::pair<std::string_view, std::function<int()>> ways[] = {
      {"crash", crash},
      {"crash_some", [&] { return to_the_right ? crash() : 1; }},
      {"crash_later", [] { return calls % 50 == 0 ? crash() : 1; }},
      {"abort", say_and_abort},
      {"exit", leave},
      {"overflow", [] { return deeper("", 1 << 30); }},
      {"throw", []() -> int { throw std::runtime_error("through C"); }},
      {"throw_number", []() -> int { throw 7; }},
      {"hang", hang},
      {"hang_some", [&] { return to_the_right ? hang() : 1; }},
      {"sleep", fall_asleep},
      {"close", shut_the_door},
      {"lie", [&] { return say_apart(contact); }},
      {"waver", [&] { return waver(pair, contact); }},
      {"leak", leak},
      {"leak_pages", leak_pages},
      {"cache", cache},
      {"print", print},
      {"spheres", [&] { return solve_spheres(&pair, contact); }},
      {"fork", [&] { return come_back_twice(pair, contact); }},
      {"forge", [&] { return forge(pair, contact); }},
      {"hog", take_all_memory},
      {"hog_slowly", [&] { return take_more_memory(pair, contact); }},
      {"kill_caller", [&] { return kill_the_caller(SIGKILL, pair, contact); }},
      {"terminate_caller", [&] { return kill_the_caller(SIGTERM, pair, contact); }},
      {"kill_group", [] { return kill(0, SIGKILL); }},
      {"kill_all", [&] { return reach_everybody(pair, contact); }},
  };
  for (const auto& [name, way] : ways)
    if (name == how) return way();
  return 1;
}

std::string_view asked_for() {
  const char* how = std::getenv("PLUMB_MISBEHAVIOUR");
  return how == nullptr ? "" : how;
}

}  // namespace

extern "C" int plumb_solver_version() {
  if (asked_for() == "crash_at_once") (void)crash();
  if (asked_for() == "hang_at_once") (void)hang();
  return PLUMB_SOLVER_VERSION;
}

extern "C" int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  ++calls;
  return misbehave(asked_for(), *pair, contact);
}

/// The overlap that it is given, and one more: whoever asks sees whether the last contact came through.
extern "C" int plumb_solver_solve_warm(const plumb_pair*, const plumb_contact* last, plumb_contact* contact) {
  (void)say_apart(contact);
  contact->overlap = last->overlap - 1;
  return 0;
}
