#include "solver/method/published/dummy_impl.hpp"

namespace plumb {

template Contact<double> dummy<double>(const Pair&, const Want&, const Contact<double>*);

}  // namespace plumb
