#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "reports/study/starts.hpp"
#include "reports/study/tables.hpp"

namespace plumb::reports {
namespace {

constexpr int all_digits = 17;

Json vector_json(const Vec3<double>& v, int digits) {
  return {rounded(v[0], digits), rounded(v[1], digits), rounded(v[2], digits)};
}

Json group_json(const Group& group, BedShape shape) {
  const Bed& bed = group.bed;
  return {{"kind", "group"},
          {"group", group.name},
          {"shape", shape == BedShape::spheroid ? "spheroid" : "superquadric"},
          {"fails", name(group.fails)},
          {"aspect", bed.aspect},
          {"exponents", {bed.n1, bed.n2}},
          {"theta_L_deg", bed.theta_L},
          {"phi_L_deg", bed.phi_L},
          {"euler_deg", {bed.euler[0], bed.euler[1], bed.euler[2]}},
          {"drawn", group.drawn}};
}

Json answer_json(const Group& group, const GroupAnswer& answer) {
  const auto& [contact, diagnosis, off] = answer.studied;
  const bool has_points = contact.point1.allFinite();
  Json out{{"kind", "answer"},
           {"group", group.name},
           {"ratio", answer.ratio},
           {"method", answer.method},
           {"status", name(contact.status)},
           {"points", nullptr},
           {"residues", nullptr},
           {"angles_deg", nullptr},
           {"off_deg", rounded(off)},
           {"certified", answer.certified}};
  if (!has_points) return out;
  out["points"] = {vector_json(contact.point1, all_digits), vector_json(contact.point2, all_digits)};
  out["residues"] = Json::array();
  for (const double r : diagnosis.residues) out["residues"].push_back(rounded(r));
  out["angles_deg"] = {rounded(diagnosis.d_n1), rounded(diagnosis.d_n2), rounded(diagnosis.n1_n2)};
  return out;
}

std::string heading(const Group& group, BedShape shape) {
  const Bed& bed = group.bed;
  const std::string what = fmt::format("{}: fails by {}", group.name, name(group.fails));
  if (group.drawn == 0) return what + ": none found";
  const std::string exponents =
      shape == BedShape::spheroid ? "" : fmt::format(", exponents {:g}, {:g}", bed.n1, bed.n2);
  return fmt::format("{}; aspect {:g}{}, theta_L {:g}, phi_L 0, phi 0, theta {:g}, psi {:g} deg (draw {})", what,
                     bed.aspect, exponents, bed.theta_L, bed.euler[1], bed.euler[2], group.drawn);
}

/// "1.2e-16", and with a mark what is no zero.
std::string residue_text(double r) {
  return std::isnan(r) ? "-" : fmt::format("{:.1e}{}", r, std::abs(r) > 1e-6 ? "*" : "");
}

std::string angle_text(double angle) {
  return std::isnan(angle) ? "-" : fmt::format("{:.2e}", angle);
}

std::string point_text(const Vec3<double>& p) {
  return p.allFinite() ? fmt::format("({:.6f}, {:.6f}, {:.6f})", p[0], p[1], p[2]) : "-";
}

const TextTable group_columns({{"ratio", "<8g"},
                               {"method", "<27"},
                               {"R1", ">10"},
                               {"R2", ">10"},
                               {"R3", ">10"},
                               {"R4", ">10"},
                               {"R5", ">10"},
                               {"d_n1", ">10"},
                               {"d_n2", ">10"},
                               {"n1_n2", ">10"},
                               {"off", ">10"},
                               {"  p1, p2", ""}});

std::string line_of(const GroupAnswer& answer) {
  const auto& [contact, d, off] = answer.studied;
  if (contact.status != Status::converged)
    return group_columns.row(answer.ratio, fmt::format("{:<27}{}", answer.method, name(contact.status)));
  const auto& r = d.residues;
  return group_columns.row(
      answer.ratio, answer.method, residue_text(r[0]), residue_text(r[1]), residue_text(r[2]), residue_text(r[3]),
      residue_text(r[4]), angle_text(d.d_n1), angle_text(d.d_n2), angle_text(d.n1_n2), angle_text(off),
      fmt::format("{} {} {}", answer.certified ? " " : "?", point_text(contact.point1), point_text(contact.point2)));
}

ReportTable table_of(BedShape shape, const StudyOptions& options) {
  ReportTable out;
  for (const Group& group : find_groups(shape, options.seed)) {
    out.lines.push_back(heading(group, shape));
    if (group.drawn == 0) continue;
    out.rows.push_back(group_json(group, shape));
    out.lines.push_back(group_columns.head());
    for (const GroupAnswer& answer : group.answers) {
      out.add(line_of(answer), answer_json(group, answer));
    }
  }
  return out;
}

Json roots_json(const PairRoots& found) {
  Json out{{"kind", "roots"},
           {"pair", found.pair},
           {"complete", found.set.complete},
           {"reason", found.set.reason},
           {"starts", found.starts},
           {"not_converged", found.not_converged},
           {"elsewhere", found.elsewhere},
           {"roots", Json::array()}};
  for (const RootStarts& one : found.roots)
    out["roots"].push_back({{"kind", name(one.root.kind)},
                            {"normal", vector_json(one.root.normal1.cast<double>(), 8)},
                            {"distance", rounded(static_cast<double>(one.root.distance), 8)},
                            {"residues", vector_json(one.root.residual.cast<double>(), 8)},
                            {"off_deg", rounded(one.off)},
                            {"starts", one.starts},
                            {"documented", one.documented}});
  return out;
}

/// "6 (31 %)": so many of a kind, and the share of the starts that end at one.
std::string kind_text(const PairRoots& found, SixRootKind kind) {
  int roots = 0, starts = 0;
  for (const RootStarts& one : found.roots)
    if (one.root.kind == kind) ++roots, starts += one.starts;
  return fmt::format("{} ({:.1f} %)", roots, 100.0 * starts / std::max(1, found.starts));
}

std::string documented_text(const PairRoots& found) {
  for (const RootStarts& one : found.roots)
    if (one.documented) return fmt::format("{}, {:.2f} deg off", name(one.root.kind), one.off);
  return "no root";
}

const TextTable root_columns({{"pair", "<27"},
                              {"roots", ">6"},
                              {"all", ">10"},
                              {"common normal", ">15"},
                              {"the same apart", ">15"},
                              {"signs", ">15"},
                              {"z", ">15"},
                              {"both", ">15"},
                              {"not converged", ">14"},
                              {"elsewhere", ">11", "  "},
                              {"its own start ends at", ""}});

std::string line_of(const PairRoots& found) {
  const auto of = [&](SixRootKind kind) { return kind_text(found, kind); };
  return root_columns.row(found.pair, found.roots.size(), found.set.complete ? "proved" : "open",
                          of(SixRootKind::common_normal), of(SixRootKind::common_normal_apart), of(SixRootKind::signs),
                          of(SixRootKind::z), of(SixRootKind::both), found.not_converged, found.elsewhere,
                          documented_text(found));
}

}  // namespace

ReportTable spheroid_groups(const StudyOptions& options) {
  return table_of(BedShape::spheroid, options);
}

ReportTable superquadric_groups(const StudyOptions& options) {
  return table_of(BedShape::superquadric, options);
}

ReportTable six_equations_roots(const StudyOptions& options) {
  ReportTable out;
  out.lines.push_back(root_columns.head());
  const double ratio = 1e-2;
  const auto add = [&](const std::string& pair, const Bed& bed) {
    const PairRoots found = find_roots(pair, pair_of(bed, ratio), options.starts, options.seed);
    out.add(line_of(found), roots_json(found));
  };
  for (const Group& group : find_groups(BedShape::spheroid, options.seed))
    if (group.drawn > 0 && !interrupted()) add(group.name + ", overlap ratio 0.01", group.bed);
  for (const double aspect : {0.5, 2.0, 3.0}) {
    if (interrupted()) break;
    Stream random("study_roots", options.seed, static_cast<std::uint64_t>(10 * aspect));
    add(fmt::format("random, aspect {:g}", aspect), any_orientation({.aspect = aspect}, random));
  }
  return out;
}

}  // namespace plumb::reports
