// The high-precision scalars: MPFR numbers through Boost.Multiprecision, kept on the stack.
//
// MPFR rather than cpp_bin_float: its pow, exp and log are correctly rounded.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace plumb {

template <unsigned Digits>
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Real50 = Real<50>;
using Real80 = Real<80>;
using Real100 = Real<100>;

}  // namespace plumb
