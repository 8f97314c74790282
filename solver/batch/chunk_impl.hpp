// A chunk of a batch; included only by the one source file of each instruction set. What is instantiated here is named by a
// type that holds the width of the registers, or is inlined by force. The linker keeps one function of each name: it must not
// keep one with instructions that a machine does not have.
#pragma once

#include <cstring>

#include "solver/batch/ellipsoid_pack.hpp"
#include "solver/batch/surface_pack.hpp"

namespace plumb::detail {

template <int width>
class ChunkSolver {
 public:
  explicit ChunkSolver(const Chunk& chunk) : chunk_(chunk) {
    for (std::size_t i = 0; i < chunk.count; i += width) sort(i);
  }

  [[nodiscard]] Unsettled solve() {
    for (std::size_t i = 0; i < ellipsoids_.count; i += width) solve_ellipsoids(ellipsoids_.index(i, chunk_.first));
    for (std::size_t i = 0; i < surfaces_.count; i += width) solve_surfaces<false>(surfaces_.index(i, chunk_.first));
    for (std::size_t i = 0; i < duals_.count; i += width) solve_surfaces<true>(duals_.index(i, chunk_.first));
    return unsettled_;
  }

 private:
  using P = Pack<width>;

  /// Offsets of pairs of a form.
  struct List {
    std::array<std::uint8_t, Chunk::capacity + width> offsets;
    std::size_t count = 0;

    void add(const std::array<std::uint8_t, width>& added, std::size_t added_count) {
      std::memcpy(&offsets[count], added.data(), width);
      count += added_count;
    }
    void add_if(bool belongs, std::uint8_t offset) {
      offsets[count] = offset;
      count += belongs ? 1 : 0;
    }
    [[nodiscard]] PackIndex<P> index(std::size_t from, std::size_t first) const {
      return PackIndex<P>(&offsets[from], count - from, first);
    }
  };

  static constexpr double least_exponent = 1.1;  // nearer to 1 the first attempt often fails: those are left to `auto`

  /// By the form that suits them.
  void sort(std::size_t from) {
    std::array<std::uint8_t, width> offsets;
    for (std::size_t lane = 0; lane < width; ++lane) offsets[lane] = static_cast<std::uint8_t>(from + lane);
    const std::size_t count = std::min<std::size_t>(width, chunk_.count - from);
    const PackIndex<P> index(offsets.data(), count, chunk_.first);
    const Exponents<P> n = load_exponents(index, chunk_.pairs);
    const P most = std::numeric_limits<double>::max();  // an infinite one is `auto`'s to refuse
    const PerBody<P> least = PerBody<P>(P(least_exponent)), two_p = PerBody<P>(P(2.0)), greatest = PerBody<P>(most);
    const auto two = n.n1 == two_p && n.n2 == two_p, above_two = n.n1 >= two_p && n.n2 >= two_p,
               usual = n.n1 >= least && n.n2 >= least && n.n1 <= greatest && n.n2 <= greatest;
    const auto are_ellipsoids = two.a && two.b, are_usual = usual.a && usual.b, are_smooth = above_two.a && above_two.b,
               are_surfaces = are_usual && are_smooth && !are_ellipsoids, are_duals = are_usual && !are_smooth;
    if (all_of(are_ellipsoids)) return ellipsoids_.add(offsets, count);
    for (std::size_t lane = 0; lane < count; ++lane) {
      ellipsoids_.add_if(are_ellipsoids[lane], offsets[lane]);
      surfaces_.add_if(are_surfaces[lane], offsets[lane]);
      duals_.add_if(are_duals[lane], offsets[lane]);
    }
    keep_unsettled(index, are_ellipsoids || are_usual);
  }

  void solve_ellipsoids(const PackIndex<P>& index) {
    const PackPair<P> placed = load_pair(index, chunk_.pairs);
    const PackStart<P> start = load_start(index, chunk_.pairs);
    store(index, placed, EllipsoidPack<P>(ellipsoid_pair<P>(placed), start, chunk_.want).solve());
  }

  /// `any_dual`: with an exponent below 2.
  template <bool any_dual>
  void solve_surfaces(const PackIndex<P>& index) {
    const PackPair<P> placed = load_pair(index, chunk_.pairs);
    const Exponents<P> n = load_exponents(index, chunk_.pairs);
    const SuperellipsoidPair<P> pair = superellipsoid_pair<P>(placed, n.n1, n.n2);
    const PackStart<P> start = load_start(index, chunk_.pairs);
    store(index, placed, SurfacePack<P, any_dual>(pair, start, chunk_.want).solve());
  }

  [[gnu::always_inline]] void store(const PackIndex<P>& index, const PackPair<P>& placed, const PackContact<P>& found) {
    store_contact(index, placed, found, chunk_.want.tolerance, chunk_.contacts);
    auto settled = found.settled && placed.valid;
    if (chunk_.want.is_yes_or_no())  // what rounding leaves open is `auto`'s to decide, by a point that both hold
      settled = settled && !is_undecided(found.overlap, placed.size, chunk_.want.tolerance);
    keep_unsettled(index, settled);
  }

  void keep_unsettled(const PackIndex<P>& index, const typename P::mask_type& settled) {
    if (all_of(settled)) return;
    for (std::size_t lane = 0; lane < width; ++lane)
      if (!settled[lane]) unsettled_ |= Unsettled(1) << (index.pair[lane] - chunk_.first);
  }

  const Chunk& chunk_;
  List ellipsoids_, surfaces_, duals_;
  Unsettled unsettled_ = 0;
};

}  // namespace plumb::detail
