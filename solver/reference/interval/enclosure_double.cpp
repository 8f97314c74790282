#include "solver/reference/interval/enclosure_impl.hpp"
#include "solver/reference/interval/interval_double.hpp"

namespace plumb::reference {

PLUMB_INSTANTIATE_ENCLOSURE(DoubleInterval)

}  // namespace plumb::reference
