#include "solver/method/published/minimum_distance_impl.hpp"

namespace plumb {

template Contact<double> minimum_distance<double>(const Pair&, const Want&, const Contact<double>*);

}  // namespace plumb
