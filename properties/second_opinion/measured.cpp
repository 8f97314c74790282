#include "measured.hpp"

#include <array>
#include <cstdio>

namespace second_opinion {
namespace {

/// About a point: both ways along three axes, and the corners.
std::vector<Vec<Quad>> about(const Vec<Quad>& x, double reach) {
  std::vector<Vec<Quad>> out;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (i != 0 || j != 0 || k != 0) out.push_back(x + Quad(reach) * Vec<Quad>{Quad(i), Quad(j), Quad(k)});
  return out;
}

/// How far the normal turns there, rad.
double spread(const Body<Quad>& body, const Vec<Quad>& x, double reach) {
  const Vec<Quad> n = body.gauge(x).slope;
  double most = 0;
  for (const Vec<Quad>& beside : about(x, reach)) most = std::max(most, angle(n, body.gauge(beside).slope));
  return most;
}

double off_surface(const Body<Quad>& body, const Vec<Quad>& x) {
  const Sloped<Quad> g = body.gauge(x);
  return static_cast<double>(fabsq(g.value - 1) / length(g.slope));
}

/// The surface goes through a box about x.
bool is_near_surface(const Body<Quad>& body, const Vec<Quad>& x, double reach) {
  if (off_surface(body, x) <= reach) return true;
  const bool is_inside = body.gauge(x).value < 1;
  for (const Vec<Quad>& beside : about(x, reach))
    if ((body.gauge(beside).value < 1) != is_inside) return true;
  return false;
}

double largest_coordinate(const GivenPair& pair) {
  return std::max(largest(pair[0].position), largest(pair[1].position));
}

}  // namespace

Measured::Measured(const Claim& claim, Truth& truth)
    : claim_(claim), truth_(truth), size_(size_of(claim.pair)),
      step_(std::numeric_limits<double>::denorm_min() / size_ / epsilon),
      far_(1 + largest_coordinate(claim.pair) / size_ + step_), expected_(truth.lowest().front()) {
  if (claim.problem == Problem::common_normal) choose_expected();
}

void Measured::choose_expected() {
  if (!claim_.answer.normal) return;
  const Vec<Quad> n = widen(*claim_.answer.normal);
  const double as_good_as_found = 1e-9, worth_a_look = 1e-7;
  if (angle(n, expected_.normal) > as_good_as_found && excess() < worth_a_look * (1 + std::fabs(truth_.proven())))
    truth_.look_from(n);
  const Minimum& lowest = truth_.lowest().front();
  const Quad tie = 32 * epsilon * (1 + fabsq(lowest.value));
  expected_ = lowest;
  for (const Minimum& m : truth_.lowest())
    if (m.value <= lowest.value + tie && angle(n, m.normal) < angle(n, expected_.normal)) expected_ = m;
}

Vec<Quad> Measured::on(int body) const {
  const Vec<Quad> x = from_first(body == 0 ? *claim_.answer.point1 : *claim_.answer.point2);
  return body == 0 ? x : x - truth_.pair().apart;
}

double Measured::normal_error() const {
  return claim_.answer.normal ? angle(widen(*claim_.answer.normal), expected_.normal) : 0;
}

double Measured::length_error() const {
  return claim_.answer.normal ? static_cast<double>(fabsq(length(widen(*claim_.answer.normal)) - 1)) : 0;
}

double Measured::overlap_error() const {
  return claim_.answer.overlap ? static_cast<double>(Quad(*claim_.answer.overlap) / size_ - expected_.value) : 0;
}

double Measured::points_error() const {
  if (!has_points()) return 0;
  return static_cast<double>(std::max(length(from_first(*claim_.answer.point1) - expected_.point1),
                                      length(from_first(*claim_.answer.point2) - expected_.point2)));
}

double Measured::inconsistency() const {
  if (!has_points() || !claim_.answer.normal || !claim_.answer.overlap) return 0;
  const Vec<Quad> d = from_first(*claim_.answer.point1) - from_first(*claim_.answer.point2);
  return static_cast<double>(length(d - Quad(*claim_.answer.overlap) / size_ * widen(*claim_.answer.normal)));
}

double Measured::gap_error() const {
  if (!has_points() || !claim_.answer.overlap) return 0;
  const Quad d = length(from_first(*claim_.answer.point1) - from_first(*claim_.answer.point2));
  return static_cast<double>(fabsq(d - fabsq(Quad(*claim_.answer.overlap)) / size_));
}

double Measured::contact_error() const {
  if (!claim_.answer.contact_point) return 0;
  const Vec<Quad> x = from_first(*claim_.answer.contact_point);
  if (claim_.problem == Problem::midway) {
    const auto at = midway_point(truth_.pair());
    return at ? static_cast<double>(length(x - *at)) : 0;
  }
  if (claim_.problem != Problem::common_normal || !has_points()) return 0;
  const Vec<Quad> p = from_first(*claim_.answer.point1), d = from_first(*claim_.answer.point2) - p;
  const Quad square = dot(d, d), share = square > 0 ? dot(x - p, d) / square : Quad(0);
  return static_cast<double>(length(x - p - std::min(std::max(share, Quad(0)), Quad(1)) * d));
}

double Measured::excess() const {
  if (!claim_.answer.normal || claim_.problem != Problem::common_normal) return 0;
  const Vec<Quad> n = unit(widen(*claim_.answer.normal));
  return static_cast<double>(look(truth_.pair(), Question::common_normal, n).value - expected_.value);
}

bool Measured::is_on_surfaces(double rounding) const {
  const double reach = rounding * epsilon * far_;
  return !has_points() || (is_near_surface(body(0), on(0), reach) && is_near_surface(body(1), on(1), reach));
}

double Measured::surface_error() const {
  return has_points() ? std::max(off_surface(body(0), on(0)), off_surface(body(1), on(1))) : 0;
}

double Measured::turned(double rounding) const {
  if (!has_points()) return 0;
  const double reach = rounding * epsilon * far_;
  const Vec<Quad> n1 = body(0).gauge(on(0)).slope, n2 = body(1).gauge(on(1)).slope;
  const double shaken1 = spread(body(0), on(0), reach), shaken2 = spread(body(1), on(1), reach);
  const double opposite = angle(n1, -n2) - 2 * (shaken1 + shaken2);
  const Vec<Quad> d = from_first(*claim_.answer.point1) - from_first(*claim_.answer.point2);
  const auto apart = static_cast<double>(length(d));
  if (apart <= 4 * reach) return std::max(0.0, opposite);
  const double to_line = std::min(angle(n1, d), angle(n1, -d)) - 2 * (shaken1 + 4 * reach / apart);
  return std::max({0.0, opposite, to_line});
}

bool Measured::are_a_pair(double rounding, double allowed) const {
  if (!has_points() || !is_on_surfaces(rounding)) return false;
  const Vec<Quad> d = from_first(*claim_.answer.point1) - from_first(*claim_.answer.point2);
  return length(d - expected_.value * expected_.normal) <= rounding * epsilon * far_ + allowed;
}

std::string Measured::figures() const {
  std::array<char, 200> text{};
  const double degrees = 180 / M_PI, got = claim_.answer.overlap.value_or(std::numeric_limits<double>::quiet_NaN());
  std::snprintf(text.data(), text.size(),
                "expected overlap %.9g, got %.9g; normal %.3g degrees off, points %.3g of the size",
                static_cast<double>(expected_.value * Quad(size_)), got, degrees * normal_error(), points_error());
  return text.data();
}

}  // namespace second_opinion
