#include "corpus/command/build_info.hpp"

#include <sys/utsname.h>

#include <string>
#include <thread>

#include "plumb_commit.hpp"

namespace plumb {

BuildInfo build_info() {
#ifdef __clang__
  constexpr const char* compiler = __VERSION__;
#else
  constexpr const char* compiler = "g++ " __VERSION__;
#endif
  return {PLUMB_COMMIT, compiler, PLUMB_FLAGS};
}

Json host_json() {
  utsname host{};
  uname(&host);
  const BuildInfo build = build_info();
  return {{"system", std::string(host.sysname) + " " + host.release},
          {"machine", host.machine},
          {"processors", std::thread::hardware_concurrency()},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"commit", build.commit}};
}

}  // namespace plumb
