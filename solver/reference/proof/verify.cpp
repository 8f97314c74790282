#include "solver/reference/proof/verify.hpp"

#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/proof/verify_impl.hpp"

namespace plumb::reference {

PLUMB_INSTANTIATE_VERIFY(Interval18)
PLUMB_INSTANTIATE_VERIFY(Interval19)
PLUMB_INSTANTIATE_VERIFY(Interval80)
template CoverProof verify_cover(const FramedPair<DoubleInterval>&, const EnclosedPair<Interval18>&, const Cover&,
                                 double);

}  // namespace plumb::reference
