// What is made of the rows of shapes.hpp: numbers by their fields, and how errors call them.
#pragma once

#include <utility>

#include "solver/shape/shapes.hpp"

namespace plumb {

namespace detail {

template <class Number>
[[nodiscard]] std::array<Number*, 1> places_of(Number& x) {
  return {&x};
}
template <class List>
  requires requires(List& x) { x[2]; }
[[nodiscard]] auto places_of(List& x) {
  constexpr std::size_t count = sizeof(List) / sizeof(double);
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{&x[static_cast<decltype(x.size())>(i)]...};
  }(std::make_index_sequence<count>());
}

template <class... Place, std::size_t... size>
[[nodiscard]] auto joined(const std::array<Place, size>&... lists) {
  return std::apply([](auto... place) { return std::array{place...}; }, std::tuple_cat(lists...));
}

/// Letters of a name that is put together when compiled; a zero ends them.
class PathText {
 public:
  constexpr PathText& operator+=(std::string_view more) {
    for (const char c : more) letters_[size_++] = c;
    return *this;
  }
  [[nodiscard]] constexpr std::string_view view() const { return {letters_.data(), size_}; }

 private:
  std::array<char, 64> letters_{};
  std::size_t size_ = 0;
};

}  // namespace detail

/// Pointers to the numbers of a field, of a shape that is const or not; none of a polyhedron's points.
template <class... Member, class S>
[[nodiscard]] auto numbers_of(const ShapeField<Member...>& field, S& shape) {
  if constexpr (sizeof...(Member) == 0)
    return std::array<std::conditional_t<std::is_const_v<S>, const double, double>*, 0>{};
  else
    return std::apply([&](auto... member) { return detail::joined(detail::places_of(shape.*member)...); },
                      field.members);
}

/// Whether a shape is its numbers, so that it can be written down.
template <class S>
inline constexpr bool is_value = !requires { RowOf<S>::is_by_functions; };

/// How many numbers a field of a shape has.
template <class S, std::size_t field>
inline constexpr std::size_t number_count =
    std::tuple_size_v<decltype(numbers_of(std::get<field>(RowOf<S>::fields), std::declval<S&>()))>;

template <class S>
inline constexpr std::size_t field_count = std::tuple_size_v<decltype(RowOf<S>::fields)>;

template <class S>
inline constexpr auto field_names =
    std::apply([](const auto&... field) { return std::array<std::string_view, sizeof...(field)>{field.name...}; },
               RowOf<S>::fields);

/// visit(place, field, numbers): each field of a shape in its order, `place` being a constant.
template <class S, class Visit>
void each_field([[maybe_unused]] S& shape, Visit&& visit) {
  using Row = RowOf<std::remove_const_t<S>>;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (visit(std::integral_constant<std::size_t, i>(), std::get<i>(Row::fields),
           numbers_of(std::get<i>(Row::fields), shape)),
     ...);
  }(std::make_index_sequence<field_count<std::remove_const_t<S>>>());
}

namespace detail {

inline constexpr std::size_t most_numbers = 6;

/// "shape.box", "shape.box.half_extents", "shape.box.half_extents[0]"
template <class S>
struct PathsOf {
  static constexpr PathText shape = PathText(PathText() += "shape.") += RowOf<S>::word;
  static constexpr PathText of(std::string_view field) { return PathText(PathText(shape) += ".") += field; }
  static constexpr auto fields = std::apply(
      [](const auto&... field) { return std::array<PathText, sizeof...(field)>{of(field.name)...}; }, RowOf<S>::fields);
  static constexpr auto elements = [] {
    std::array<std::array<PathText, most_numbers>, field_count<S>> out{};
    for (std::size_t field = 0; field < out.size(); ++field)
      for (std::size_t i = 0; i < most_numbers; ++i)
        (((out[field][i] += fields[field].view()) += "[") += std::string_view("0123456789").substr(i, 1)) += "]";
    return out;
  }();
};

}  // namespace detail

/// "shape.box.half_extents[1]"; of a number by itself "shape.capsule.radius". It lives as long as the program and ends with a zero.
template <class S, std::size_t field>
[[nodiscard]] constexpr std::string_view path_of(std::size_t number) {
  using Paths = detail::PathsOf<S>;
  if constexpr (number_count<S, field> == 1)
    return Paths::fields[field].view();
  else
    return Paths::elements[field][number].view();
}

/// One of the shape, for examples and tests: each length half of the one before, 1 the first.
template <class S>
[[nodiscard]] S sample_of() {
  S out{};
  double next = 1;
  each_field(out, [&](auto, const auto& field, const auto& numbers) {
    if (!field.is_length()) return;
    for (double* number : numbers) *number = std::exchange(next, next / 2);
  });
  return out;
}

}  // namespace plumb
