// A kernel; included by patch.cpp, for the baseline, and by the one source file of each instruction set beyond it. What is instantiated there is
// named by a type that holds the width of the registers, or is inlined by force: the linker keeps one function of each name.
#pragma once

#include "solver/patch/caps.hpp"
#include "solver/patch/kernel.hpp"
#include "solver/patch/meridians.hpp"
#if defined(__GLIBCXX__)
#include "solver/method/pack.hpp"
#endif

namespace plumb::detail {

template <class P>
[[nodiscard]] constexpr LensKernel kernel_of() {
  return {find_exits<P>, find_rims<P>, add_fans<P>, add_meridians<P>};
}

}  // namespace plumb::detail
