#include "reports/study/maps.hpp"

#include <cmath>

#include "corpus/command/in_parallel.hpp"
#include "fuzz/results/tally.hpp"
#include "reports/bench/quantile.hpp"

namespace plumb::reports {
namespace {

/// Of one pair, by method; the first says whether they are held against a proof.
struct Offs {
  bool certified = false;
  std::vector<double> off;
  std::vector<bool> converged;
};

Offs offs_of(const Pair& pair) {
  const CertifiedNormal truth = certified_normal(pair);
  Offs out;
  out.certified = truth.proved;
  for (const std::string_view method : studied()) {
    const Studied one = study(method, pair, truth);
    out.off.push_back(one.off);
    out.converged.push_back(one.contact.status == Status::converged);
  }
  return out;
}

std::vector<Offs> all_offs(const std::vector<Pair>& pairs, unsigned threads) {
  std::vector<Offs> out(pairs.size());
  in_parallel(pairs.size(), threads, [&](std::size_t i) { out[i] = offs_of(pairs[i]); });
  return out;
}

std::vector<double> degrees(int to, int step) {
  std::vector<double> out;
  for (int x = 0; x <= to; x += step) out.push_back(x);
  return out;
}

std::vector<MisalignmentMap> maps_of(double aspect, double phi, double ratio, unsigned threads) {
  const std::vector<double> theta_L = degrees(90, 5), theta = degrees(180, 10);
  std::vector<Pair> pairs;
  for (const double zenith : theta_L)
    for (const double tilt : theta) pairs.push_back(pair_of({aspect, 2, 2, zenith, 0, {phi, tilt, 0}}, ratio));
  const std::vector<Offs> offs = all_offs(pairs, threads);
  std::vector<MisalignmentMap> out;
  for (std::size_t k = 0; k < studied().size(); ++k) {
    MisalignmentMap map{aspect, phi, ratio, studied()[k], theta_L, theta, {}, 0};
    for (std::size_t i = 0; i < offs.size(); ++i) {
      if (i % theta.size() == 0) map.off.emplace_back();
      map.off.back().push_back(offs[i].off[k]);
      map.not_certified += offs[i].certified ? 0 : 1;
    }
    out.push_back(std::move(map));
  }
  return out;
}

MisalignedShare share_of_method(std::size_t k, const std::vector<Offs>& offs, double aspect, double ratio) {
  MisalignedShare out{aspect, ratio, studied()[k]};
  std::vector<double> values;
  for (const Offs& one : offs) {
    if (!one.certified) continue;
    ++out.pairs;
    if (!one.converged[k]) continue;
    values.push_back(one.off[k]);
    out.off += one.off[k] > off_by ? 1 : 0;
  }
  out.answers = static_cast<int>(values.size());
  const Share share = share_of(static_cast<std::uint64_t>(out.off), values.size());
  out.low = share.low;
  out.high = share.high;
  out.median = quantile(values, 0.5);
  return out;
}

}  // namespace

std::vector<MisalignmentMap> find_maps(unsigned threads) {
  std::vector<MisalignmentMap> out;
  for (const double aspect : map_aspects)
    for (const double phi : map_phis)
      for (const double ratio : map_ratios) {
        if (interrupted()) return out;
        for (MisalignmentMap& map : maps_of(aspect, phi, ratio, threads)) out.push_back(std::move(map));
      }
  return out;
}

std::vector<MisalignedShare> find_shares(int pairs, std::uint64_t seed, unsigned threads) {
  std::vector<MisalignedShare> out;
  for (const double aspect : map_aspects)
    for (const double ratio : map_ratios) {
      if (interrupted()) return out;
      std::vector<Pair> drawn;
      for (int i = 0; i < pairs; ++i) {
        Stream random("study_orientation", seed, static_cast<std::uint64_t>(i));
        drawn.push_back(pair_of(any_orientation({.aspect = aspect}, random), ratio));
      }
      const std::vector<Offs> offs = all_offs(drawn, threads);
      for (std::size_t k = 0; k < studied().size(); ++k) out.push_back(share_of_method(k, offs, aspect, ratio));
    }
  return out;
}

}  // namespace plumb::reports
