#include "solver/method/published/geometric_potential_impl.hpp"

namespace plumb {

template Contact<double> geometric_potential<double>(const Pair&, const Want&, const Contact<double>*);
template Contact<double> geometric_potential_midway<double>(const Pair&, const Want&, const Contact<double>*);

}  // namespace plumb
