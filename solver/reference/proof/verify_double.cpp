#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/proof/verify_impl.hpp"

namespace plumb::reference {

PLUMB_INSTANTIATE_VERIFY(DoubleInterval)

}  // namespace plumb::reference
