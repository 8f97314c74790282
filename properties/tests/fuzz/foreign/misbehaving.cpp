// A foreign solver that does what the environment variable PLUMB_MISBEHAVIOUR says; refuses every pair otherwise.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <utility>

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
