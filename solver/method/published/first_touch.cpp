#include "solver/method/published/first_touch_impl.hpp"

namespace plumb {

template Contact<double> undone_motion<double>(const Pair&, const Want&, const Contact<double>*);

}  // namespace plumb
