#include "solver/method/automatic_impl.hpp"

namespace plumb {

template Contact<float> automatic_in_callers_mode<float>(const Pair&, const Want&, const Contact<float>*);
template Contact<double> automatic_in_callers_mode<double>(const Pair&, const Want&, const Contact<double>*);
template Contact<long double> automatic_in_callers_mode<long double>(const Pair&, const Want&,
                                                                     const Contact<long double>*);
template Contact<float> automatic<float>(const Pair&, const Want&, const Contact<float>*);
template Contact<double> automatic<double>(const Pair&, const Want&, const Contact<double>*);
template Contact<long double> automatic<long double>(const Pair&, const Want&, const Contact<long double>*);

}  // namespace plumb
