#include "solver/method/published/common_normal_impl.hpp"

namespace plumb {

template Contact<double> original_cn<double>(const Pair&, const Want&, const Contact<double>*);
template Contact<double> corrected_cn<double>(const Pair&, const Want&, const Contact<double>*);
template Contact<double> new_cn<double>(const Pair&, const Want&, const Contact<double>*);

}  // namespace plumb
