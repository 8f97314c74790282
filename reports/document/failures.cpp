#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "corpus/case/case.hpp"
#include "corpus/case/shape_class.hpp"
#include "corpus/certificate/certificate.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "corpus/solvers/solver.hpp"
#include "fuzz/results/ranking.hpp"
#include "properties/laws/judged_answer.hpp"
#include "reports/document/document.hpp"
#include "solver/diagnosis.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb::reports {
namespace {

Json vector_or_null(const Vec3<double>& v) {
  return v.allFinite() ? Json{v[0], v[1], v[2]} : Json();
}

Json two_or_null(const Vec3<double>& a, const Vec3<double>& b) {
  return a.allFinite() && b.allFinite() ? Json{vector_or_null(a), vector_or_null(b)} : Json();
}

/// Of surfaces that have one everywhere.
Json normals_json(const Pair& pair, const Vec3<double>& point1, const Vec3<double>& point2) {
  if (!point1.allFinite() || !point2.allFinite()) return nullptr;
  const ContactNormals normals = normals_at(pair, point1, point2);
  return two_or_null(normals.normal1, normals.normal2);
}

/// The fields that an answer and the reference share.
Json contact_json(Verdict verdict, double overlap, const Vec3<double>& normal, const Vec3<double>& point1,
                  const Vec3<double>& point2) {
  return {{"verdict", name(verdict)},
          {"overlap", number_json(overlap)},
          {"normal", vector_or_null(normal)},
          {"points", two_or_null(point1, point2)},
          {"normals", nullptr},
          {"iterations", nullptr},
          {"angle_error_deg", nullptr}};
}

Json reference_json(const Pair& pair, const Reference& reference) {
  const Solution& found = reference.common_normal;
  const Vec3<double> point1 = found.point1.cast<double>(), point2 = found.point2.cast<double>();
  Json out =
      contact_json(reference.verdict, static_cast<double>(found.overlap), found.normal.cast<double>(), point1, point2);
  out["normals"] = normals_json(pair, point1, point2);
  out["status"] = found.solved ? "solved" : "not solved: " + found.reason;
  return out;
}

/// Of the normals of lowest overlap, the nearest; NaN where there is none.
double angle_to(const Reference& reference, const Vec3<double>& normal) {
  double least = std::numeric_limits<double>::quiet_NaN();
  const auto look_at = [&](const Solution& s) {
    if (s.solved && normal.allFinite()) least = std::fmin(least, angle_deg(normal, s.normal.cast<double>()));
  };
  look_at(reference.common_normal);
  for (const Solution& tied : reference.tied) look_at(tied);
  return least;
}

Json answer_json(const Contact<double>& c) {
  Json out = contact_json(c.verdict, c.overlap, c.normal, c.point1, c.point2);
  out["status"] = name(c.status);
  out["iterations"] = c.iterations;
  return out;
}

Json answer_json(const Pair& pair, const Contact<double>& c, const Reference& reference) {
  Json out = answer_json(c);
  out["normals"] = normals_json(pair, c.point1, c.point2);
  out["angle_error_deg"] = number_json(angle_to(reference, c.normal));
  return out;
}

/// What is known of the right answer to a pair of any shapes: bounds of the overlap, and no normal.
Json reference_json(const reference::ConvexBounds& bounds) {
  const Verdict verdict = bounds.lower > 0   ? Verdict::overlapping
                          : bounds.upper < 0 ? Verdict::separated
                                             : Verdict::undecided;
  const Vec3<double> none = not_valid<double>();
  Json out = contact_json(verdict, bounds.lower / 2 + bounds.upper / 2, none, none, none);
  out["status"] = fmt::format("bounds of the overlap alone: {:.17g} .. {:.17g}", bounds.lower, bounds.upper);
  return out;
}

/// By name, each loaded once. Of foreign solvers only those that are handed over: what a file names is never loaded.
class Solvers {
 public:
  explicit Solvers(const std::vector<Solver>& foreign) {
    for (const Solver& solver : foreign) found_.emplace(solver.name, solver);
  }
  const Solver& find(const std::string& method) {
    const auto known = found_.find(method);
    return known != found_.end() ? known->second : found_.emplace(method, find_solvers(method).front()).first->second;
  }

 private:
  std::map<std::string, Solver> found_;
};

/// The finest level of accuracy at which the answer breaks no law; null where it breaks one at each.
Json right_from(const Judgement& judgement) {
  const std::size_t level = judgement.right_from;
  return level < right_at_no_level ? Json(accuracy_levels[level].name) : Json();
}

constexpr const char* no_answer = "a finding of the reference itself: there is no answer of a method";

/// The method that a finding is about; nothing where it is about the reference.
std::optional<std::string> method_of(const Case& kept) {
  const auto& method = kept.expect.method;
  return method == "reference" ? std::nullopt : method;
}

void solve_again(Json& failure, const Pair& pair, const std::optional<std::string>& method, Solvers& solvers) {
  const Reference reference = find_reference(pair, Effort::bounds);
  failure["reference"] = reference_json(pair, reference);
  if (!method) {
    failure["reason"] = no_answer;
    return;
  }
  const Solver& solver = solvers.find(*method);
  failure["answer"] = answer_json(pair, solver.solve(pair, {}, nullptr), reference);
  Judge judge(pair);
  failure["right_from"] = right_from(solve_and_judge(judge, pair, solver).judgement);
}

/// The answer's own normal is where the bounds begin to look.
void solve_again(Json& failure, const ConvexPair& pair, const std::optional<std::string>& method, Solvers& solvers) {
  const auto bounds_near = [&](const Vec3<double>& normal) {
    return reference_json(reference::bound_overlap(pair, normal, kConvexCells));
  };
  const Solver* const solver = method ? &solvers.find(*method) : nullptr;
  if (solver == nullptr || !solver->solve_convex) {
    failure["reference"] = bounds_near(not_valid<double>());
    failure["reason"] = solver == nullptr ? no_answer : solver->name + " takes superellipsoids alone";
    return;
  }
  const JudgedAnswer judged = solve_and_judge(pair, *solver, {});
  failure["reference"] = bounds_near(judged.answer.normal);
  failure["answer"] = answer_json(judged.answer);
  failure["right_from"] = right_from(judged.judgement);
}

/// Puts in "answer", "reference" and "right_from", or null and the "reason".
void solve_again(Json& failure, const Case& kept, Solvers& solvers) {
  failure["answer"] = failure["reference"] = failure["right_from"] = nullptr;
  try {
    if (kept.convex)
      solve_again(failure, *kept.convex, method_of(kept), solvers);
    else
      solve_again(failure, kept.pair, method_of(kept), solvers);
  } catch (const std::exception& e) {
    failure["reason"] = e.what();
  }
}

/// In a bucket's name, and for people.
std::string shapes_of(const Case& kept, const char* between) {
  if (!kept.convex) return shape_class(kept.pair);
  return fmt::format("{}{}{}", name(kept.convex->body1.shape), between, name(kept.convex->body2.shape));
}

/// What stands between finding, method and shapes of a bucket's name and its end; "" where nothing does.
std::string regime_in(const RankedBucket& bucket, const Case& kept) {
  const std::string before = bucket.finding + "-" + bucket.method + "-" + shapes_of(kept, "-") + "-";
  return bucket.name.starts_with(before) ? bucket.name.substr(before.size()) : "";
}

/// As the page's other commands: whoever reads it has another folder of programs.
std::string replay_of(const std::filesystem::path& file, const RankedBucket& bucket) {
  return fmt::format("plumb replay {}{}", shell_word(file.string()), bucket.options);
}

/// The simplest case as `plumb campaign --shrink` left it, in numbers and in a sentence; null where it did not.
Json shrunk_json(const Run& run, const RankedBucket& bucket, Solvers& solvers) {
  const auto file = run.folder / "failures" / (bucket.name + std::string(kShrunk));
  if (!std::filesystem::exists(file)) return nullptr;
  const Case kept = parse_case(read_text(file), file.string(), 0, CaseShapes::every);
  Json out{{"explanation", kept.provenance.value("explanation", "")},
           {"file", file.string()},
           {"replay", replay_of(file, bucket)},
           {"case", Json::parse(format_case(kept))}};
  solve_again(out, kept, solvers);
  return out;
}

Json failure_json(const Run& run, const RankedBucket& bucket, const Failure& failure, const char* kept) {
  const Case& c = failure.kept;
  const Json& from = c.provenance;
  const auto file =
      run.folder / "failures" / (bucket.name + std::string(kept == std::string_view("worst") ? kWorst : kSimplest));
  return {{"bucket", bucket.name},
          {"kept", kept},
          {"count", bucket.count},
          {"finding", bucket.finding},
          {"method", bucket.method},
          {"shapes", shapes_of(c, " against ")},
          {"regime", regime_in(bucket, c)},
          {"family", from.value("family", "")},
          {"own", bucket.own},
          {"severity", from.at("severity")},
          {"law", from.value("law", "")},
          {"detail", from.value("detail", "")},
          {"file", file.string()},
          {"replay", replay_of(file, bucket)},
          {"case", Json::parse(format_case(c))}};
}

/// Plumb's own first; then each method's most frequent in turn, so that no method fills the gallery.
std::vector<RankedBucket> in_turns(std::vector<RankedBucket> ranked) {
  std::map<std::string, int> seen;
  std::vector<std::pair<int, RankedBucket>> turns;
  for (RankedBucket& bucket : ranked) {
    const int turn = bucket.own ? -1 : seen[bucket.method]++;
    turns.emplace_back(turn, std::move(bucket));
  }
  std::stable_sort(turns.begin(), turns.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < turns.size(); ++i) ranked[i] = std::move(turns[i].second);
  return ranked;
}

}  // namespace

Json failures_json(const Run& run, const Shown& shown) {
  Solvers solvers(shown.foreign);
  Json out = Json::array();
  const auto put = [&](const RankedBucket& bucket, const Failure& failure, const char* kept) {
    if (out.size() >= shown.most_failures || interrupted()) return;
    out.push_back(failure_json(run, bucket, failure, kept));
    solve_again(out.back(), failure.kept, solvers);
  };
  for (const RankedBucket& bucket : in_turns(ranked_buckets(run.results))) {
    const KeptBucket& kept = run.results.kept.buckets().at(bucket.name);
    const bool one = is_one_case(kept);
    put(bucket, kept.simplest, one ? "only" : "simplest");
    if (Json shrunk = shrunk_json(run, bucket, solvers); !shrunk.is_null()) out.back()["shrunk"] = std::move(shrunk);
    if (!one) put(bucket, kept.worst, "worst");
  }
  return out;
}

}  // namespace plumb::reports
