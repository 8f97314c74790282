#include <fmt/format.h>

#include <cmath>

#include "corpus/command/text_table.hpp"
#include "reports/study/cost.hpp"
#include "reports/study/limits.hpp"
#include "reports/study/maps.hpp"
#include "reports/study/tables.hpp"

namespace plumb::reports {
namespace {

std::string number_text(double x) {
  return std::isnan(x) ? "-" : fmt::format("{:.2e}", x);
}

std::string order_text(double x) {
  return std::isnan(x) ? "-" : fmt::format("{:.2f}", x);
}

const TextTable share_columns({{"aspect", "<8g"},
                               {"ratio", "<8g"},
                               {"method", "<27"},
                               {"pairs", ">7"},
                               {"answers", ">9"},
                               {"off %", ">9.1f", " "},
                               {"[95 %]", "<12"},
                               {"median, deg", ">12"}});

std::string line_of(const MisalignedShare& s) {
  return share_columns.row(s.aspect, s.ratio, s.method, s.pairs, s.answers, 100.0 * s.off / std::max(1, s.answers),
                           fmt::format("[{:.1f}, {:.1f}]", 100 * s.low, 100 * s.high), number_text(s.median));
}

Json share_json(const MisalignedShare& s) {
  return {{"kind", "share"},
          {"aspect", s.aspect},
          {"ratio", s.ratio},
          {"method", s.method},
          {"pairs", s.pairs},
          {"answers", s.answers},
          {"off", s.off},
          {"low", rounded(s.low)},
          {"high", rounded(s.high)},
          {"median_deg", rounded(s.median)}};
}

Json map_json(const MisalignmentMap& map) {
  const int digits = 3;
  Json off = Json::array();
  for (const std::vector<double>& row : map.off) {
    off.push_back(Json::array());
    for (const double x : row) off.back().push_back(x < 1e-12 ? Json(0) : rounded(x, digits));
  }
  return {{"kind", "map"},          {"aspect", map.aspect}, {"phi_deg", map.phi},
          {"ratio", map.ratio},     {"method", map.method}, {"theta_L_deg", map.theta_L},
          {"theta_deg", map.theta}, {"off_deg", off},       {"not_certified", map.not_certified}};
}

const TextTable limit_columns({{"sweep", "<10"},
                               {"of", "<33"},
                               {"at", "<10g"},
                               {"system", "<27"},
                               {"proved", "<9"},
                               {"angle, deg", ">11"},
                               {"most", ">11"},
                               {"point", ">11"},
                               {"overlap", ">11"}});

std::string line_of(const Limit& limit) {
  return limit_columns.row(limit.sweep, limit.shape, limit.x, limit.system,
                           fmt::format("{:>4}/{}", limit.certified, limit.pairs), number_text(limit.angle),
                           number_text(limit.angle_max), number_text(limit.point), number_text(limit.overlap));
}

Json limit_json(const Limit& limit) {
  return {{"kind", "limit"},
          {"sweep", limit.sweep},
          {"shape", limit.shape},
          {"x", limit.x},
          {"system", limit.system},
          {"pairs", limit.pairs},
          {"certified", limit.certified},
          {"angle_deg", rounded(limit.angle)},
          {"angle_max_deg", rounded(limit.angle_max)},
          {"point", rounded(limit.point)},
          {"overlap", rounded(limit.overlap)}};
}

const TextTable order_columns({{"order of ratio", "<43"},
                               {"system", "<27"},
                               {"angle", ">9"},
                               {"point", ">9"},
                               {"overlap", ">9"},
                               {"angle at 1e-6", ">14"}});

std::string line_of(const Order& order) {
  return order_columns.row(order.shape, order.system, order_text(order.angle), order_text(order.point),
                           order_text(order.overlap), number_text(order.limit));
}

Json order_json(const Order& order) {
  return {{"kind", "order"},
          {"shape", order.shape},
          {"system", order.system},
          {"angle", rounded(order.angle)},
          {"point", rounded(order.point)},
          {"overlap", rounded(order.overlap)},
          {"limit_deg", rounded(order.limit)}};
}

const TextTable cost_columns({{"set", "<18"},
                              {"target", "<10g"},
                              {"method", "<27"},
                              {"pairs", ">7"},
                              {"tolerance", ">11"},
                              {"evaluations", ">13"},
                              {"within %", ">10.1f"}});

std::string line_of(const Cost& cost) {
  const std::string tolerance = std::isnan(cost.tolerance) ? "-" : fmt::format("{:g}", cost.tolerance);
  const std::string evaluations = std::isnan(cost.evaluations) ? "-" : fmt::format("{:g}", cost.evaluations);
  return cost_columns.row(cost.set, cost.target, cost.method, cost.pairs, tolerance, evaluations, 100 * cost.share);
}

Json cost_json(const Cost& cost) {
  return {{"kind", "cost"},
          {"set", cost.set},
          {"method", cost.method},
          {"target_deg", cost.target},
          {"tolerance", std::isnan(cost.tolerance) ? Json() : Json(cost.tolerance)},
          {"evaluations", rounded(cost.evaluations)},
          {"share", rounded(cost.share)}};
}

}  // namespace

ReportTable misalignment_shares(const StudyOptions& options) {
  ReportTable out;
  out.lines.push_back(share_columns.head());
  for (const MisalignedShare& share : find_shares(options.orientations, options.seed, options.threads)) {
    out.add(line_of(share), share_json(share));
  }
  return out;
}

ReportTable misalignment_maps(const StudyOptions& options) {
  ReportTable out;
  int pairs = 0, not_certified = 0;
  for (const MisalignmentMap& map : find_maps(options.threads)) {
    out.rows.push_back(map_json(map));
    if (map.method != studied().front()) continue;
    pairs += static_cast<int>(map.theta_L.size() * map.theta.size());
    not_certified += map.not_certified;
  }
  out.lines.push_back(fmt::format("{} maps of {} pairs; of {} the common normal is not proved, and left out",
                                  out.rows.size(), pairs, not_certified));
  return out;
}

ReportTable limits_and_sweeps(const StudyOptions& options) {
  ReportTable out;
  const Limits found = find_limits(options.pairs, options.seed, options.threads);
  out.lines.push_back(order_columns.head());
  for (const Order& order : found.orders) {
    out.add(line_of(order), order_json(order));
  }
  out.lines.push_back(limit_columns.head());
  for (const Limit& limit : found.limits) {
    out.add(line_of(limit), limit_json(limit));
  }
  return out;
}

ReportTable costs_at_equal_accuracy(const StudyOptions& options) {
  ReportTable out;
  out.lines.push_back(cost_columns.head());
  for (const Cost& cost : find_costs(options.cost_pairs, options.seed, options.threads)) {
    out.add(line_of(cost), cost_json(cost));
  }
  return out;
}

}  // namespace plumb::reports
