// Newton's iteration of method/surface_newton.hpp from the first start of method/surface_contact.hpp, on a pack of pairs
// with exponents of 2 and more. Lanes that need another attempt or the search over directions are not settled.
//
// A lane's answer is kept when it ends, for a step of zero would not give the same bits again.
#pragma once

#include "solver/batch/pack_pair.hpp"
#include "solver/method/surface_contact.hpp"

namespace plumb {

template <class P>
class SurfacePack {
 public:
  using Lanes = typename P::mask_type;

  [[gnu::always_inline]] SurfacePack(const SuperellipsoidPair<P>& pair, const Want& want)
      : pair_(pair), limit_(std::min(want.iteration_limit, most_iterations)),
        tolerance_(std::max(4 * epsilon<double>(), want.tolerance)) {}

  SurfacePack(const SurfacePack&) = delete;
  SurfacePack& operator=(const SurfacePack&) = delete;

  [[nodiscard]] PackContact<P> solve() {
    const SurfaceStart<P> start{pair_};
    *here_ = start.at(start.direction(), StartKind::mixed, pair_.inner, pair_.outer);
    set_equations(pair_, *here_, f_);
    P last(std::numeric_limits<double>::infinity());
    for (int i = 0;; ++i) {
      const P now = residual(f_);
      keep(is_small_enough(now, last), f_);
      if (i == limit_ || none_of(active_ && now < P(std::numeric_limits<double>::infinity()))) break;
      last = now;
      step(now);
      if (none_of(active_)) break;
    }
    out_.settled = out_.settled && out_.overlap <= pair_.rolling_ball;
    return out_;
  }

 private:
  // Of the first attempt alone; a pack waits for its slowest lane.
  static constexpr int most_iterations = 14;

  [[nodiscard, gnu::always_inline]] P residual(const SurfaceEquations<P>& f) const {
    return max(f.twist, P(f.slope / pair_.reach));
  }

  [[nodiscard, gnu::always_inline]] Lanes is_small_enough(const P& now, const P& last) const {
    return f_.opposite && is_at_rest(now, last, tolerance_);
  }

  /// The answer of the lanes that end at f; a saddle is none.
  [[gnu::always_inline]] void keep(const Lanes& small_enough, const SurfaceEquations<P>& f) {
    const Lanes ends = active_ && small_enough;
    if (none_of(ends)) return;
    active_ = active_ && !ends;
    out_.settled = out_.settled || (ends && is_minimum(pair_, f));
    out_.normal = blend(ends, f.m, out_.normal);
    out_.point1 = blend(ends, f.point1, out_.point1);
    out_.point2 = blend(ends, f.point2, out_.point2);
    out_.overlap = blend(ends, f.overlap, out_.overlap);
  }

  [[gnu::always_inline]] void step(const P& now) {
    out_.iterations = blend(active_, out_.iterations + P(1.0), out_.iterations);
    const std::array<P, 4> x = cleaned(solve4(system()));
    const Lanes close = active_ && f_.opposite && now < P(1e-7);
    if (any_of(close)) follow(close, x);
    if (none_of(active_)) return;
    move(x);
  }

  [[nodiscard, gnu::always_inline]] std::array<Equation4<P>, 4> system() const {
    P o = f_.overlap;
    const Lanes deep = o > pair_.rolling_ball;
    if (any_of(deep)) o = blend(deep && o > hessian_of(pair_, f_).lower_eigenvalue(), P(0.0), o);
    std::array<Equation4<P>, 4> m = newton_system(f_, o);
    const Lanes still = f_.twist < tolerance_;
    for (std::size_t k = 0; k < 2; ++k) m[k].right = blend(still, P(0.0), m[k].right);
    return m;
  }

  [[nodiscard, gnu::always_inline]] static P squared_length(const std::array<P, 4>& x) {
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
  }

  /// Without infinities and NaN.
  [[nodiscard, gnu::always_inline]] static std::array<P, 4> cleaned(std::array<P, 4> x) {
    const Lanes clean = squared_length(x) < P(1e200);
    if (all_of(clean)) return x;
    for (P& component : x) {
      const P most(1e3), clamped = min(max(component, P(-most)), most);
      component = blend(clean, component, blend(component == component, clamped, P(0.0)));
    }
    return x;
  }

  /// The last step, along the tangents, of the lanes where it is short enough.
  [[gnu::always_inline]] void follow(const Lanes& close, const std::array<P, 4>& x) {
    const Followed<P> to = followed(*here_, both<P>(x[0], x[2]), both<P>(x[1], x[3]));
    const P top = pair_.greatest_nu, square = max(squared_length(x), hmax(to.squared_turn));
    const Lanes lanes = close && square * top * top < P(0.05 * epsilon<double>()) * hmin(room_to_fold(pair_, *here_));
    if (none_of(lanes)) return;
    SurfaceEquations<P>& f = spare_;
    f.dnormal = f_.dnormal;
    f.dpoint = f_.dpoint;
    set_values<P>(pair_, to.point, pair_.rotation * to.normal * inverse_length<P>(to.normal), f);
    keep(lanes && residual(f) < tolerance_, f);
  }

  [[gnu::always_inline]] void move(const std::array<P, 4>& x) {
    out_.evaluations = blend(active_, out_.evaluations + P(1.0), out_.evaluations);
    const P square = squared_length(x), whole = blend(square > P(1.0), P(P(1.0) / sqrt(square)), P(1.0));
    const P t = blend(active_, whole, P(0.0));
    move_surfaces<P, false>(pair_, pair_.inner, pair_.outer, *here_, both<P>(x[0], x[2]) * Both<P>(t),
                            both<P>(x[1], x[3]) * Both<P>(t), *there_);
    std::swap(here_, there_);
    set_equations(pair_, *here_, f_);
  }

  const SuperellipsoidPair<P>& pair_;
  int limit_;
  P tolerance_;
  Surfaces<P> surfaces_, other_surfaces_;
  Surfaces<P>*here_ = &surfaces_, *there_ = &other_surfaces_;
  SurfaceEquations<P> f_, spare_;
  Lanes active_ = Lanes(true);
  PackContact<P> out_{Lanes(false), {}, {}, {}, P(0.0), P(0.0), P(1.0)};
};

}  // namespace plumb
