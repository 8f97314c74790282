// What is minimised over all directions: a quotient of two support functions, f(n) = top(n) / bottom(n).
//
// common normal   top: of body 1 less body 2, h1(n) + h2(-n) - n.c, c from centre 1 to centre 2; bottom: |n|. f is then the overlap o(n): how far
//                 body 2 has to go along n until a plane across n parts the bodies. The least is the depth, or minus the distance.
// deepest point   of surface 1 in body 2's potential: top: of body 1 seen from centre 2, h1(n) - n.c; bottom: h2(n). f is the factor by which
//                 body 2 grows about its centre until it fills body 1's inside (centre 2 in body 1), or minus that at which it touches (outside).
//
// Where f is least, grad top = f grad bottom.
#pragma once

#include "bodies.hpp"

namespace second_opinion {

enum class Question { common_normal, deepest_of_first, deepest_of_second };

template <class T>
struct Seen {
  T value;  ///< f(n)
  T top, bottom;
  Vec<T> point1, point2;  ///< of the surfaces where n and -n are the normals, from body 1's centre; where a
                          ///< deepest point's f is least both are it, seen from its own body and from the other
  Vec<T> top_slope, bottom_slope;
};

template <class T>
Seen<T> of_supports(const Sloped<T>& top, const Sloped<T>& bottom) {
  Seen<T> out{};
  out.top = top.value;
  out.bottom = bottom.value;
  out.value = top.value / bottom.value;
  out.top_slope = top.slope;
  out.bottom_slope = bottom.slope;
  return out;
}

template <class T>
Seen<T> look(const Pair<T>& pair, Question question, const Vec<T>& n) {
  const Sloped<T> first = pair.first.support(n), second = pair.second.support(n);
  const T along = dot(n, pair.apart);
  if (question == Question::common_normal) {
    const T size = length(n);
    Seen<T> out = of_supports<T>({first.value + second.value - along, first.slope + second.slope - pair.apart},
                                 {size, (T(1) / size) * n});
    out.point1 = first.slope;
    out.point2 = pair.apart - second.slope;
    return out;
  }
  if (question == Question::deepest_of_first) {
    Seen<T> out = of_supports<T>({first.value - along, first.slope - pair.apart}, second);
    out.point1 = first.slope;
    out.point2 = pair.apart + out.value * second.slope;
    return out;
  }
  Seen<T> out = of_supports<T>({second.value + along, second.slope + pair.apart}, first);
  out.point1 = pair.apart + second.slope;
  out.point2 = out.value * first.slope;
  return out;
}

/// grad f; it is across n.
template <class T>
Vec<T> slope(const Seen<T>& seen) {
  return (T(1) / seen.bottom) * (seen.top_slope - seen.value * seen.bottom_slope);
}

}  // namespace second_opinion
