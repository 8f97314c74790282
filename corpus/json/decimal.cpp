#include "corpus/json/decimal.hpp"

#include <array>
#include <limits>

namespace plumb {
namespace {

mpfr_rnd_t mode_of(Rounding rounding) {
  if (rounding == Rounding::nearest) return MPFR_RNDN;
  return rounding == Rounding::down ? MPFR_RNDD : MPFR_RNDU;
}

}  // namespace

std::string decimal(const Real50& x, int digits, Rounding rounding) {
  const Real50 value = x == 0 ? Real50(0) : x;  // zero has no sign here
  std::array<char, 160> text{};
  (void)mpfr_snprintf(text.data(), text.size(), "%.*R*e", digits - 1, mode_of(rounding), value.backend().data());
  return text.data();
}

Real50 read_decimal(const std::string& text, Rounding rounding) {
  Real50 out;
  char* end = nullptr;
  (void)mpfr_strtofr(out.backend().data(), text.c_str(), &end, 10, mode_of(rounding));
  const bool decimal_text = !text.empty() && text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  if (decimal_text && end == text.c_str() + text.size() && mpfr_number_p(out.backend().data()) != 0) return out;
  return std::numeric_limits<Real50>::quiet_NaN();
}

}  // namespace plumb
