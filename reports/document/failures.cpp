#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "corpus/case/case.hpp"
#include "corpus/case/shape_class.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "corpus/solvers/solver.hpp"
#include "fuzz/results/ranking.hpp"
#include "properties/laws/judged_answer.hpp"
#include "reports/document/document.hpp"
#include "solver/diagnosis.hpp"

namespace plumb::reports {
namespace {

Json vector_or_null(const Vec3<double>& v) {
  return v.allFinite() ? Json{v[0], v[1], v[2]} : Json();
}

Json two_or_null(const Vec3<double>& a, const Vec3<double>& b) {
  return a.allFinite() && b.allFinite() ? Json{vector_or_null(a), vector_or_null(b)} : Json();
}

/// The fields that an answer and the reference share.
Json contact_json(const Pair& pair, Verdict verdict, double overlap, const Vec3<double>& normal,
                  const Vec3<double>& point1, const Vec3<double>& point2) {
  const auto normals = point1.allFinite() && point2.allFinite()
                           ? normals_at(pair, point1, point2)
                           : ContactNormals{not_valid<double>(), not_valid<double>()};
  return {{"verdict", name(verdict)},
          {"overlap", number_json(overlap)},
          {"normal", vector_or_null(normal)},
          {"points", two_or_null(point1, point2)},
          {"normals", two_or_null(normals.normal1, normals.normal2)},
          {"iterations", nullptr},
          {"angle_error_deg", nullptr}};
}

Json reference_json(const Pair& pair, const Reference& reference) {
  const Solution& found = reference.common_normal;
  Json out = contact_json(pair, reference.verdict, static_cast<double>(found.overlap), found.normal.cast<double>(),
                          found.point1.cast<double>(), found.point2.cast<double>());
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

Json answer_json(const Pair& pair, const Contact<double>& c, const Reference& reference) {
  Json out = contact_json(pair, c.verdict, c.overlap, c.normal, c.point1, c.point2);
  out["status"] = name(c.status);
  out["iterations"] = c.iterations;
  out["angle_error_deg"] = number_json(angle_to(reference, c.normal));
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
Json right_from(const Pair& pair, const Solver& solver) {
  Judge judge(pair);
  const std::size_t level = solve_and_judge(judge, pair, solver).judgement.right_from;
  return level < right_at_no_level ? Json(accuracy_levels[level].name) : Json();
}

/// Puts in "answer", "reference" and "right_from", or null and the "reason".
void solve_again(Json& failure, const Case& kept, Solvers& solvers) {
  failure["answer"] = failure["reference"] = failure["right_from"] = nullptr;
  try {
    const Reference reference = find_reference(kept.pair, Effort::bounds);
    failure["reference"] = reference_json(kept.pair, reference);
    if (!kept.expect.method || *kept.expect.method == "reference") {
      failure["reason"] = "a finding of the reference itself: there is no answer of a method";
      return;
    }
    const Solver& solver = solvers.find(*kept.expect.method);
    failure["answer"] = answer_json(kept.pair, solver.solve(kept.pair, {}, nullptr), reference);
    failure["right_from"] = right_from(kept.pair, solver);
  } catch (const std::exception& e) {
    failure["reason"] = e.what();
  }
}

/// What stands between finding, method and shapes of a bucket's name and its end.
std::string regime_in(const RankedBucket& bucket, const std::string& before) {
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
  const Case kept = parse_case(read_text(file), file.string());
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
  const std::string shapes = shape_class(c.pair);
  const auto file =
      run.folder / "failures" / (bucket.name + std::string(kept == std::string_view("worst") ? kWorst : kSimplest));
  return {{"bucket", bucket.name},
          {"kept", kept},
          {"count", bucket.count},
          {"finding", bucket.finding},
          {"method", bucket.method},
          {"shapes", shapes},
          {"regime", regime_in(bucket, bucket.finding + "-" + bucket.method + "-" + shapes + "-")},
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
