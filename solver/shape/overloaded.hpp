// One function of several, for std::visit.
#pragma once

namespace plumb::detail {

template <class... Case>
struct Overloaded : Case... {
  using Case::operator()...;
};
template <class... Case>
Overloaded(Case...) -> Overloaded<Case...>;  // what clang 14 does not deduce by itself

}  // namespace plumb::detail
