#include "corpus/solvers/host/confinement.hpp"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>

namespace plumb {
namespace {

/// A rule of the filter that goes on at one of two later places.
sock_filter jump_if(std::uint32_t value, std::size_t then) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, static_cast<std::uint8_t>(then), 0);
}

}  // namespace

void be_expendable() {
  const rlimit none{0, 0};
  (void)setrlimit(RLIMIT_CORE, &none);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

std::vector<pid_t> parent_and_all() {
  const pid_t plumb = getppid();
  return {plumb, -getpgid(plumb), -1};
}

void keep_signals_from(const std::vector<pid_t>& spared) {
  constexpr std::array<std::uint32_t, 6> calls{
      SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_pidfd_open};
  const sock_filter allow = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  std::vector<sock_filter> rules{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (std::size_t i = 0; i < calls.size(); ++i) rules.push_back(jump_if(calls[i], calls.size() - i));
  rules.push_back(allow);
  rules.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args)));
  for (std::size_t i = 0; i < spared.size(); ++i)
    rules.push_back(jump_if(static_cast<std::uint32_t>(spared[i]), spared.size() - i));
  rules.push_back(allow);
  rules.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM));
  const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
  (void)prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  (void)syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
}

}  // namespace plumb
