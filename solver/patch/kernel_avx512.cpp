// Built with -mavx512f and its kin; run only where the machine has them.
#include "solver/patch/kernel_impl.hpp"

#if defined(__GLIBCXX__)
namespace plumb::detail {

constinit const LensKernel lens_kernel_avx512 = kernel_of<Pack<8>>();

}  // namespace plumb::detail
#endif
