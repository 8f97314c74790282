#include "fuzz/shrink/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/case/shape_class.hpp"
#include "fuzz/results/failure_store.hpp"

namespace plumb {
namespace {

std::string text_of(const Vec3<double>& v) {
  return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

const char* spheroid_word(const Vec3<double>& axes) {
  const double own = axes[0] == axes[1] ? axes[2] : (axes[0] == axes[2] ? axes[1] : axes[0]);
  const double radius = axes[0] == axes[1] || axes[0] == axes[2] ? axes[0] : axes[1];
  if (own >= 10 * radius) return "needle";
  if (radius >= 10 * own) return "disc";
  return own > radius ? "prolate spheroid" : "oblate spheroid";
}

std::string shape_text(const Superellipsoid<double>& shape) {
  switch (shape_kind(shape)) {
    case ShapeKind::sphere: return fmt::format("sphere of radius {}", shape.semi_axes[0]);
    case ShapeKind::spheroid: return spheroid_word(shape.semi_axes) + (" " + text_of(shape.semi_axes));
    case ShapeKind::ellipsoid: return "ellipsoid " + text_of(shape.semi_axes);
    default:
      return fmt::format("superquadric {} with exponents {} and {}", text_of(shape.semi_axes), shape.n1, shape.n2);
  }
}

std::string with_article(const std::string& noun) {
  return (std::string("aeiou").find(noun.front()) == std::string::npos ? "a " : "an ") + noun;
}

std::string shapes_text(const Pair& pair) {
  const std::string one = shape_text(pair.body1.shape), two = shape_text(pair.body2.shape);
  return one == two ? with_article(one) + " against another" : with_article(one) + " against " + with_article(two);
}

std::string turned_text(const Vec3<double>& angles, int body) {
  if (angles[0] == 0 && angles[2] == 0) return fmt::format(", body {} tilted by {} degrees", body, angles[1]);
  return fmt::format(", body {} turned by the Euler angles {} degrees", body, text_of(angles));
}

std::string pose_text(const Described& d) {
  std::string out;
  for (std::size_t i = 0; i < 2 && d.euler_deg; ++i)
    if (!(*d.euler_deg)[i].isZero(0)) out += turned_text((*d.euler_deg)[i], static_cast<int>(i) + 1);
  if (!d.euler_deg) out += ", turned by quaternions";
  if (!d.place)
    return out + fmt::format(", body 2's centre at {}", text_of(d.pair.body2.position - d.pair.body1.position));
  const Vec3<double>& place = *d.place;
  const std::string depth = place[2] > 0   ? fmt::format("at {:.3g} % overlap", 100 * place[2])
                            : place[2] < 0 ? fmt::format("{:.3g} % apart", -100 * place[2])
                                           : "just touching";
  return out + fmt::format(", {} on a line of centres at zenith {} and azimuth {} degrees", depth, place[0], place[1]);
}

std::string done_text(const Finding& finding) {
  switch (finding.kind) {
    case FindingKind::crash: return "crashes";
    case FindingKind::not_finite: return "answers with a NaN or an infinity";
    case FindingKind::nonconverged: return fmt::format("gives up ({})", finding.detail);
    case FindingKind::false_contact: return "sees a contact where there is none";
    case FindingKind::missed_contact: return "misses the contact";
    case FindingKind::wrong_branch: return "finds a common normal that is not the lowest";
    case FindingKind::off_surface: return "gives points off their surfaces";
    case FindingKind::overlap_error: return "gives a wrong overlap";
    case FindingKind::point_error: return "gives wrong points";
    case FindingKind::asymmetric: return "answers differently to the same question";
    case FindingKind::nondeterministic: return "changes its answer from call to call";
    case FindingKind::slow: return fmt::format("takes {}", finding.detail);
    default: return "is misaligned";
  }
}

/// In the units of the answer, where the certified overlap is known.
std::string overlaps_text(const JudgedAnswer& found) {
  const double expected = found.judgement.overlap, got = found.answer.overlap;
  if (std::isnan(expected) || !std::isfinite(got)) return found.judgement.finding.detail;
  return fmt::format("expected overlap {:.6g}, got {:.6g}", expected, got);
}

/// What stands beside the words of done_text; empty where they say it all.
std::string figures_text(const Pair& pair, const JudgedAnswer& found) {
  const std::string size = size_text(defect_of(pair, found));
  const std::string turned = size.empty() ? "" : "normal " + size + " off";
  switch (found.judgement.finding.kind) {
    case FindingKind::misaligned: return turned.empty() ? found.judgement.finding.detail : turned;
    case FindingKind::wrong_branch: return overlaps_text(found) + (turned.empty() ? "" : "; " + turned);
    case FindingKind::false_contact:
    case FindingKind::missed_contact:
    case FindingKind::overlap_error: return overlaps_text(found);
    case FindingKind::off_surface:
    case FindingKind::point_error:
    case FindingKind::asymmetric: return found.judgement.finding.detail;
    default: return "";
  }
}

std::string what_happens(const Pair& pair, const JudgedAnswer& found) {
  const std::string figures = figures_text(pair, found);
  return done_text(found.judgement.finding) + (figures.empty() ? "" : " (" + figures + ")");
}

bool is_alone(const Range& range) {
  return range.low == range.high && range.gone_below && range.gone_above;
}

std::string range_text(const Range& range) {
  const std::string& words = range.number.words;
  if (is_alone(range)) return fmt::format("{} exactly {}", words, range.low);
  // A tilt or zenith ends by itself, at 0 and 180.
  const bool ends = range.number.quantity == Quantity::zenith;
  std::string out = fmt::format("{} from {}", words, range.low);
  if (range.open_low && !ends) out += " (or less)";
  if (!range.gone_below && !range.open_low) out += " (less was not tried)";
  out += fmt::format(" to {}{}", range.open_high && !ends ? "at least " : "", range.high);
  if (!range.gone_above && !range.open_high) out += " (more was not tried)";
  return out;
}

std::string matters_text(const std::vector<Range>& ranges) {
  std::string out;
  for (const Range& range : ranges)
    if (range.matters())
      out += (out.empty() ? "; one number changed at a time, it persists at every value tried of " : ", ") +
             range_text(range);
  return out;
}

std::string untried_text(const std::vector<Range>& ranges) {
  std::string out;
  for (const Range& range : ranges)
    if (!range.finished) out += (out.empty() ? "; not tried to the end: " : ", ") + range.number.words;
  return out;
}

std::string indifference_text(const std::vector<Range>& ranges) {
  const auto matters = [](const Range& r) { return r.matters(); };
  const auto indifferent = [](const Range& r) { return !r.matters() && r.finished; };
  const std::string untried = untried_text(ranges);
  if (std::none_of(ranges.begin(), ranges.end(), indifferent)) return untried;
  if (!untried.empty() || std::any_of(ranges.begin(), ranges.end(), matters))
    return untried + "; the other numbers do not matter (still there at every value tried)";
  return "; no number matters (changed one at a time: still there at every value tried)";
}

/// What is true of a number, in fields.
Json range_json(const Range& range) {
  Json out{
      {"number", range.number.field}, {"words", range.number.words}, {"value", range.number.value}, {"low", range.low},
      {"high", range.high},           {"open_low", range.open_low},  {"open_high", range.open_high}};
  if (range.gone_below) out["gone_below"] = *range.gone_below;
  if (range.gone_above) out["gone_above"] = *range.gone_above;
  out["tried"] = range.tried;
  out["finished"] = range.finished;
  return out;
}

Json ranges_json(const std::vector<Range>& ranges, bool matter, bool finished) {
  Json out = Json::array();
  for (const Range& range : ranges)
    if (range.matters() == matter && (matter || range.finished == finished)) out.push_back(range_json(range));
  return out;
}

std::string row_text(const Range& range) {
  const std::string where =
      is_alone(range) ? fmt::format("{} alone", range.low) : fmt::format("{} .. {}", range.low, range.high);
  std::string gone;
  if (range.gone_below) gone += fmt::format("gone at {}", *range.gone_below);
  if (range.gone_above) gone += fmt::format("{} {}", gone.empty() ? "gone at" : " and", *range.gone_above);
  if (gone.empty() && range.finished) gone = "does not matter";
  if (!range.finished) gone += gone.empty() ? "not tried to the end" : ", not tried to the end";
  return fmt::format("  {:<28} {:<12} {:<28} {}, {} tried\n", range.number.words, range.number.value, where, gone,
                     range.tried);
}

}  // namespace

std::string sentence(const Shrunk& shrunk, const std::vector<Range>& ranges, const std::string& method) {
  return fmt::format("{} {} for {}{}{}{}", method, what_happens(shrunk.pair, shrunk.found), shapes_text(shrunk.pair),
                     pose_text(shrunk.described), matters_text(ranges), indifference_text(ranges));
}

Explained shrink_and_explain(const Pair& pair, const Solver& solver, const Accuracy& accuracy) {
  Explained out{shrink(pair, solver, accuracy), {}, {}, {}};
  out.counts = out.shrunk.counts;
  if (out.shrunk.from.judgement.finding.kind == FindingKind::none) return out;
  out.ranges = find_ranges(out.shrunk, solver, out.counts);
  out.sentence = sentence(out.shrunk, out.ranges, solver.name);
  return out;
}

Case kept_shrunk(const Case& from, const Explained& explained, const std::string& method) {
  Case bare;
  bare.name = from.name;
  bare.pair = explained.shrunk.pair;
  bare.provenance = Json{{"shrunk_from", from.name}};
  const auto severity = [](const JudgedAnswer& of) { return severity_json(of.judgement.finding.severity); };
  Case kept = failing_case(bare, method, explained.shrunk.found.judgement.finding, explained.shrunk.accuracy, "");
  kept.provenance.erase("command");
  kept.provenance["from_severity"] = severity(explained.shrunk.from);
  kept.provenance["explanation"] = explained.sentence;
  kept.provenance["described"] = described_json(explained.shrunk.described);
  if (!from.provenance.is_null()) kept.provenance["from"] = from.provenance;
  return kept;
}

Json explained_json(const Case& from, const Explained& explained, const std::string& method) {
  const Shrunk& shrunk = explained.shrunk;
  const Finding& finding = shrunk.found.judgement.finding;
  Json out{{"name", from.name}, {"method", method}, {"finding", name(finding.kind)}};
  if (finding.kind == FindingKind::none) return out;
  out["severity"] = severity_json(finding.severity);
  out["from_severity"] = severity_json(shrunk.from.judgement.finding.severity);
  out["case"] = Json::parse(format_case(kept_shrunk(from, explained, method)));
  out["explanation"] = explained.sentence;
  out["matters"] = ranges_json(explained.ranges, true, true);
  out["indifferent"] = ranges_json(explained.ranges, false, true);
  out["not_tried_to_the_end"] = ranges_json(explained.ranges, false, false);
  out["stopped"] = shrunk.stopped;
  out["judged"] = explained.counts.judged;
  out["solved"] = explained.counts.solved;
  out["work_ms"] = static_cast<double>(explained.counts.work) / 1e6;
  return out;
}

std::string explained_text(const Case& from, const Explained& explained, const std::string& method) {
  const Shrunk& shrunk = explained.shrunk;
  if (shrunk.from.judgement.finding.kind == FindingKind::none)
    return fmt::format("{}: {} has no finding, there is nothing to shrink", from.name, method);
  std::string out = explained.sentence + "\n\n";
  for (const Range& range : explained.ranges) out += row_text(range);
  out += fmt::format("\n{} pairs solved, {} of them held against a certified reference{}\n\n", explained.counts.solved,
                     explained.counts.judged, shrunk.stopped ? "; stopped there, it may become simpler" : "");
  Json text{{"format", "plumb/case-1"}, {"name", from.name}};
  text.update(described_json(shrunk.described));
  text["expect"] = {{"method", method}, {"finding", name(shrunk.found.judgement.finding.kind)}};
  return out + write_json(text);
}

}  // namespace plumb
