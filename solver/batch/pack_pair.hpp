// Pairs of a chunk in the lanes of packs, each in its own frame (as pose.hpp places a single one), and their answers.
#pragma once

#include <array>
#include <cstring>

#include "solver/batch/chunk.hpp"
#include "solver/method/auto/framed_pair.hpp"
#include "solver/method/pack.hpp"

namespace plumb {

/// The pairs of a pack. Lanes without a pair of their own hold the last one's again: what they write is that one's answer.
template <class P>
struct PackIndex {
  static constexpr std::size_t width = P::size();
  std::array<std::size_t, width> pair;
  bool contiguous;

  PackIndex(const std::uint8_t* offsets, std::size_t count, std::size_t first) {
    for (std::size_t lane = 0; lane < width; ++lane) pair[lane] = first + offsets[std::min(lane, count - 1)];
    contiguous = count >= width && pair[width - 1] - pair[0] == width - 1;
  }

  template <class T>
  [[nodiscard, gnu::always_inline]] P load(const std::span<const T>& from) const {
    if (contiguous) return P(&from[pair[0]], std::experimental::element_aligned);
    return P([&](auto lane) { return static_cast<double>(from[pair[lane]]); });
  }
  template <class T>
  [[nodiscard, gnu::always_inline]] Vector3<P> load(const std::array<std::span<const T>, 3>& from) const {
    return {load(from[0]), load(from[1]), load(from[2])};
  }
  [[gnu::always_inline]] void store(const P& value, const std::span<double>& to) const {
    if (to.empty()) return;
    if (contiguous) return value.copy_to(&to[pair[0]], std::experimental::element_aligned);
    for (std::size_t lane = 0; lane < width; ++lane) to[pair[lane]] = value[lane];
  }
  [[gnu::always_inline]] void store(const Vector3<P>& value, const std::array<std::span<double>, 3>& to) const {
    store(value.x, to[0]);
    store(value.y, to[1]);
    store(value.z, to[2]);
  }
  /// As whole numbers, or enumerators.
  template <class T>
  [[gnu::always_inline]] void store_as(const P& value, const std::span<T>& to) const {
    static_assert(sizeof(T) == sizeof(int));
    if (to.empty()) return;
    std::array<int, width> numbers;
    std::experimental::static_simd_cast<int>(value).copy_to(numbers.data(), std::experimental::element_aligned);
    if (contiguous) return void(std::memcpy(&to[pair[0]], numbers.data(), sizeof(numbers)));
    for (std::size_t lane = 0; lane < width; ++lane) to[pair[lane]] = static_cast<T>(numbers[lane]);
  }
};

template <class P>
struct PackPair : FramedPair<P> {
  Vector3<P> position1;         ///< world
  P unit;                       ///< of length, the power of two that was divided by
  typename P::mask_type valid;  ///< and in the range where a power of two is a number; other lanes hold anything
};

namespace detail {

/// Finite, and its power of two and the reciprocal of that normal.
template <class T>
[[nodiscard, gnu::always_inline]] inline auto is_usual(const T& x) {
  return x > T(1e-300) && x < T(1e300);
}

template <class P>
[[nodiscard, gnu::always_inline]] inline Matrix3<PerBody<P>>
load_rotation(const PackIndex<P>& index, const PairArrays& pairs, typename P::mask_type& valid) {
  const auto component = [&](std::size_t k) {
    return PerBody<P>(index.load(pairs.body1.quaternion[k]), index.load(pairs.body2.quaternion[k]));
  };
  const PerBody<P> w = component(0), x = component(1), y = component(2), z = component(3);
  const PerBody<P> most = max(max(abs(w), abs(x)), max(abs(y), abs(z)));
  const PerBody<P> zero = (w - w) + (x - x) + (y - y) + (z - z);  // NaN where one is not finite
  const Mask<P> is_valid = is_usual(most) && zero == PerBody<P>(P(0.0));
  valid = valid && is_valid.a && is_valid.b;
  const PerBody<P> scale = PerBody<P>(P(0.5)) / PerBody<P>(power_below(most.a), power_below(most.b));
  return rotation_of<PerBody<P>>(w * scale, x * scale, y * scale, z * scale);
}

/// Finite, and so far from the largest double that no answer of usual sizes is infinite.
template <class P>
[[nodiscard, gnu::always_inline]] inline auto is_in_reach(const Vector3<P>& v) {
  const P most(1e300);
  return abs(v.x) < most && abs(v.y) < most && abs(v.z) < most;
}

}  // namespace detail

/// Large units are divided out before the subtraction, small ones after it (place(), pose_impl.hpp).
template <class P>
[[nodiscard, gnu::always_inline]] inline PackPair<P> load_pair(const PackIndex<P>& index, const PairArrays& pairs) {
  PackPair<P> out;
  const Vector3<PerBody<P>> axes = per_body(index.load(pairs.body1.semi_axes), index.load(pairs.body2.semi_axes));
  const PerBody<P> longest = max(axes.x, max(axes.y, axes.z)), shortest = min(axes.x, min(axes.y, axes.z));
  const P size = max(longest.a, longest.b), one(1.0);
  out.position1 = index.load(pairs.body1.position);
  const Vector3<P> position2 = index.load(pairs.body2.position);
  const Vector3<PerBody<P>> finite_axes{axes.x - axes.x, axes.y - axes.y, axes.z - axes.z};
  const PerBody<P> zero = finite_axes.x + finite_axes.y + finite_axes.z;
  out.valid = detail::is_usual(size) && min(shortest.a, shortest.b) > P(0.0) && zero.a + zero.b == P(0.0) &&
              detail::is_in_reach(out.position1) && detail::is_in_reach(position2);
  out.rotation = detail::load_rotation(index, pairs, out.valid);
  out.unit = power_below(size);
  const P factor = one / out.unit, large = min(factor, one), small = max(factor, one);
  out.semi_axes = axes * PerBody<P>(factor);
  out.size = size * factor;
  out.c = (position2 * large - out.position1 * large) * small;
  out.reach = max(out.size, largest(out.c));
  out.valid = out.valid && largest(out.c) < P(1e150);  // beyond it squares overflow
  return out;
}

template <class P>
struct Exponents {
  PerBody<P> n1, n2;
};

template <class P>
[[nodiscard, gnu::always_inline]] inline Exponents<P> load_exponents(const PackIndex<P>& index,
                                                                     const PairArrays& pairs) {
  const auto load = [&](const std::span<const double>& n) { return n.empty() ? P(2.0) : index.load(n); };
  return {PerBody<P>(load(pairs.body1.n1), load(pairs.body2.n1)),
          PerBody<P>(load(pairs.body1.n2), load(pairs.body2.n2))};
}

/// Where warm starts begin: charts of any length, of the lanes that have them.
template <class P>
struct PackStart {
  Vector3<PerBody<P>> charts;
  typename P::mask_type is_warm;
};

template <class P>
[[nodiscard, gnu::always_inline]] inline PackStart<P> load_start(const PackIndex<P>& index, const PairArrays& pairs) {
  if (pairs.last.chart1[0].empty()) return {for_each_body(absent<P>()), typename P::mask_type(false)};
  const auto chart = [&](const auto& last, const auto& before, const auto& bend) {
    const Vector3<P> at = index.load(last);
    if (before[0].empty()) return at;
    return chart_ahead(at, index.load(before), bend[0].empty() ? absent<P>() : index.load(bend));
  };
  const Vector3<P> chart1 = chart(pairs.last.chart1, pairs.before_last.chart1, pairs.bend.bend1),
                   chart2 = chart(pairs.last.chart2, pairs.before_last.chart2, pairs.bend.bend2);
  const P finite(std::numeric_limits<double>::max());
  return {per_body(chart1, chart2), largest(chart1) <= finite && largest(chart2) <= finite};
}

/// What a lane found, in the pair's frame.
template <class P>
struct PackContact {
  typename P::mask_type settled;
  Vector3<P> normal, point1, point2, chart1, chart2;
  P overlap, iterations, evaluations;
};

/// To which an overlap is known.
template <class P>
[[nodiscard, gnu::always_inline]] inline P verdict_floor(const P& size, double tolerance) {
  return P(tolerance::undecided * std::numeric_limits<double>::epsilon() + tolerance) * size;
}

template <class P>
[[nodiscard, gnu::always_inline]] inline auto is_undecided(const P& overlap, const P& size, double tolerance) {
  return !(abs(overlap) > verdict_floor(size, tolerance));
}

/// The values of Verdict.
template <class P>
[[nodiscard, gnu::always_inline]] inline P verdict_of(const P& overlap, const P& size, double tolerance) {
  const P floor = verdict_floor(size, tolerance);
  const auto value = [](Verdict verdict) { return P(static_cast<double>(verdict)); };
  return blend(overlap > floor, value(Verdict::overlapping),
               blend(overlap < -floor, value(Verdict::separated), value(Verdict::undecided)));
}

template <class P>
[[gnu::always_inline]] inline void store_contact(const PackIndex<P>& index, const PackPair<P>& pair,
                                                 const PackContact<P>& found, double tolerance,
                                                 const ContactArrays& to) {
  const auto world = [&](const Vector3<P>& x) { return x * pair.unit + pair.position1; };
  index.store_as(P(static_cast<double>(Status::converged)), to.status);
  index.store_as(verdict_of(found.overlap, pair.size, tolerance), to.verdict);
  index.store(found.overlap * pair.unit, to.overlap);
  index.store(found.normal, to.normal);
  index.store(found.normal, to.separating);
  index.store(world(found.point1), to.point1);
  index.store(world(found.point2), to.point2);
  index.store(world((found.point1 + found.point2) * P(0.5)), to.contact_point);
  index.store(found.chart1, to.chart1);
  index.store(found.chart2, to.chart2);
  index.store_as(found.iterations, to.iterations);
  index.store_as(found.evaluations, to.evaluations);
}

}  // namespace plumb
