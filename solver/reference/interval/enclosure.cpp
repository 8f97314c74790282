#include "solver/reference/interval/enclosure.hpp"

#include "solver/reference/interval/enclosure_impl.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"

namespace plumb::reference {

PLUMB_INSTANTIATE_ENCLOSURE(Interval18)
PLUMB_INSTANTIATE_ENCLOSURE(Interval19)
PLUMB_INSTANTIATE_ENCLOSURE(Interval80)

}  // namespace plumb::reference
