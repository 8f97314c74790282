#include "reports/study/starts.hpp"

#include "corpus/command/interrupt.hpp"
#include "properties/generators/draft.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::reports {
namespace {

Vec3<double> any_point(const Body& body, Stream& random) {
  const Mat3<double> r = rotation<double>(body.quaternion);
  const Vec3<double> n = random_direction(random);
  return body.position + r * support_point<double>(body.shape, n).gradient;
}

/// The root at which original_cn ends from an earlier contact, or from its own start.
struct End {
  bool converged = false;
  std::optional<std::size_t> root;
};

End end_of(const Pair& pair, const SixRoots& set, const Contact<double>* start) {
  const double near = 1e-6 * size_of(pair);
  const Contact<double> c = find_method("original_cn")->solve(pair, {}, start);
  if (c.status != Status::converged) return {};
  return {true, find_root(set, c.point1, c.point2, near)};
}

void count(PairRoots& out, const End& end) {
  ++out.starts;
  if (!end.converged)
    ++out.not_converged;
  else if (end.root)
    ++out.roots[*end.root].starts;
  else
    ++out.elsewhere;
}

}  // namespace

PairRoots find_roots(const std::string& name, const Pair& pair, int starts, std::uint64_t seed) {
  PairRoots out{name, find_six_roots(pair), {}, 0, 0, 0};
  const CertifiedNormal truth = certified_normal(pair);
  for (const SixRoot& root : out.set.roots)
    out.roots.push_back({root, truth.proved ? angle_deg(root.normal1.cast<double>(), truth.normal)
                                            : std::numeric_limits<double>::quiet_NaN()});
  const End documented = end_of(pair, out.set, nullptr);
  if (documented.root) out.roots[*documented.root].documented = true;
  for (int i = 0; i < starts && !interrupted(); ++i) {
    Stream random("study_start", seed, static_cast<std::uint64_t>(i));
    Contact<double> start;
    start.point1 = any_point(pair.body1, random);
    start.point2 = any_point(pair.body2, random);
    count(out, end_of(pair, out.set, &start));
  }
  return out;
}

}  // namespace plumb::reports
