// A count of every allocation of the program, Eigen's included, by glibc's own entry point. For one source file of a test
// program; absent where the address sanitizer has the entry points.
#pragma once

#include <cstdlib>

#if !defined(__SANITIZE_ADDRESS__)
extern "C" void* __libc_malloc(std::size_t);  // NOLINT(bugprone-reserved-identifier)
namespace {
thread_local long allocations = 0;
}
extern "C" void* malloc(std::size_t size) {  // NOLINT(misc-definitions-in-headers)
  ++allocations;
  return __libc_malloc(size);
}
#endif
