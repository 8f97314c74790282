#include "solver/reference/reference.hpp"

#include <algorithm>
#include <array>

#include "solver/reference/certify.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {

std::string_view name(Claim claim) {
  constexpr std::array<std::string_view, 3> names{"open", "proved", "disproved"};
  return names[static_cast<std::size_t>(claim)];
}

std::string_view name(Effort effort) {
  constexpr std::array<std::string_view, 3> names{"bounds", "proof", "digits"};
  return names[static_cast<std::size_t>(effort)];
}

bool names_all_ties(const Reference& reference) {
  if (!reference.common_normal.proved) return false;
  if (reference.unique == Claim::proved) return true;
  return !reference.tied.empty() && reference.open.empty() &&
         std::all_of(reference.tied.begin(), reference.tied.end(), [](const Solution& s) { return s.proved; });
}

bool names_all_lowest(const Reference& reference) {
  return reference.global == Claim::proved && names_all_ties(reference);
}

Reference find_reference(const Pair& pair, Effort effort, const Reference* cheaper) {
  const StandardArithmetic mode;
  using namespace reference;
  Reference out;
  switch (effort) {
    case Effort::bounds: out = certify<DoubleInterval, double>(pair, cheaper); break;
    case Effort::proof: out = certify<Interval18, long double>(pair, cheaper); break;
    case Effort::digits: out = certify<Interval80, Real50>(pair, cheaper); break;
  }
  out.effort = effort;
  return out;
}

}  // namespace plumb
