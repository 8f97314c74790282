// Built with -mavx2; run only where the machine has it.
#include "solver/patch/kernel_impl.hpp"

#if defined(__GLIBCXX__)
namespace plumb::detail {

constinit const LensKernel lens_kernel_avx2 = kernel_of<Pack<4>>();

}  // namespace plumb::detail
#endif
