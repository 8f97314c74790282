#include "corpus/scene/scene_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "corpus/case/shape_class.hpp"
#include "corpus/file/output_file.hpp"
#include "corpus/json/fields.hpp"
#include "solver/method/automatic.hpp"

namespace plumb::scene {
namespace {

// What counts as hard. A warm start takes a handful of evaluations, a cold one a dozen.
constexpr int many_iterations = 20, many_evaluations = 40, many_changes = 6;
constexpr double large_condition = 100;
/// From here on a contact's condition is looked at, whatever else it does.
constexpr int suspect_evaluations = 16;

/// How far the normal turns for a turn of either body (rad a rad), or for a shift by the larger body's size.
double condition_of(const Pair& pair) {
  Want want;
  want.derivatives = true;
  const Contact<double> answer = automatic<double>(pair, want, nullptr);
  if (answer.status != Status::converged || !answer.derivatives) return 0;
  double out = 0;
  for (const auto& derivative : *answer.derivatives)
    out = std::max({out, derivative.normal_by_turn.norm(), size_of(pair) * derivative.normal_by_shift.norm()});
  return std::isfinite(out) ? out : 0;
}

std::string bucket_of(const char* reason, const Pair& pair, double measure) {
  return fmt::format("{}-{}-1e{}", reason, shape_class(pair), static_cast<int>(std::floor(std::log10(measure))));
}

Json case_tree(const Case& c) {
  return read_json(format_case(c));
}

Case case_in(const Field& kept) {
  const Field field = kept.member("case");
  try {
    return parse_case(write_json(field.value()), "case");
  } catch (const InputFailure& error) {
    kept.fail(error.what());
  }
}

std::uint32_t body_in(const Field& change, std::size_t i) {
  return static_cast<std::uint32_t>(change.element(i, 3, "numbers").natural(std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

Recorder::Recorder(const Scene& scene, Simulation& run, Looks looks)
    : scene_(scene.name.empty() ? "scene" : scene.name), run_(run), looks_(looks) {
  look_at_start();
  run_.observe([this](std::span<const SolveNote> notes) { look(notes); });
}

/// The first round is over when a simulation is there: its contacts are solved once more, cold as they were.
void Recorder::look_at_start() {
  if (looks_ == Looks::for_failures && run_.totals().failed == 0) return;
  const Contacts& contacts = run_.world().contacts;
  std::vector<SolveNote> notes;
  for (std::size_t c = 0; c < contacts.pairs.size(); ++c) {
    if (run_.world().bodies.is_wall(contacts.pairs[c][1])) continue;
    const Contact<double> answer = automatic<double>(run_.pair_of(c), run_.plan().want, nullptr);
    const bool touches = (*contacts.is_pressing)[c] != 0;
    notes.push_back(
        {static_cast<std::uint32_t>(c), answer.status, answer.iterations, answer.evaluations, touches, touches});
  }
  look(notes);
}

void Recorder::look(std::span<const SolveNote> notes) {
  for (const SolveNote& note : notes)
    if (note.status != Status::converged) keep(failures_, note, "nonconverged", std::max(1, note.evaluations));
  if (looks_ == Looks::for_hard) look_for_hard(notes);
}

void Recorder::look_for_hard(std::span<const SolveNote> notes) {
  const SolveNote* suspect = nullptr;
  for (const SolveNote& note : notes) {
    if (note.iterations >= many_iterations) keep(cases_, note, "iterations", note.iterations);
    if (note.evaluations >= many_evaluations) keep(cases_, note, "evaluations", note.evaluations);
    if (note.failed_warm) keep(cases_, note, "warm_start", note.evaluations);
    if (note.touched != note.touches) look_at_change(note);
    if (!note.touched && note.touches) look_at_condition(note);
    if (note.evaluations >= suspect_evaluations && (suspect == nullptr || note.evaluations > suspect->evaluations))
      suspect = &note;
  }
  if (suspect != nullptr) look_at_condition(*suspect);
}

void Recorder::look_at_condition(const SolveNote& note) {
  const double condition = condition_of(run_.pair_of(note.contact));
  if (condition >= large_condition) keep(cases_, note, "condition", condition);
}

void Recorder::look_at_change(const SolveNote& note) {
  const auto [i, j] = run_.world().contacts.pairs[note.contact];
  const int changes = ++changes_[{i, j}];
  if (changes >= many_changes) keep(cases_, note, "verdict_changes", changes);
}

/// What a case file can hold: of bodies that a run has lost, there is none.
void Recorder::keep(Buckets& buckets, const SolveNote& note, const char* reason, double measure) {
  if (!is_valid(run_.pair_of(note.contact))) return;
  const std::string bucket = bucket_of(reason, run_.pair_of(note.contact), measure);
  const auto found = buckets.find(bucket);
  if (found != buckets.end() && found->second.measure >= measure) return;
  buckets[bucket] = {measure, case_of(note, bucket, reason, measure)};
}

Case Recorder::case_of(const SolveNote& note, const std::string& name, const char* reason, double measure) const {
  const auto [i, j] = run_.world().contacts.pairs[note.contact];
  Case out;
  out.name = scene_ + "-" + name;
  out.pair = run_.pair_of(note.contact);
  out.provenance = {{"found_by", "plumb scene"}, {"scene", scene_},
                    {"step", run_.steps()},      {"time", run_.time()},
                    {"bodies", {i, j}},          {"reason", reason},
                    {"measure", measure},        {"status", std::string(plumb::name(note.status))}};
  return out;
}

std::string Recorder::state() const {
  const auto tree_of = [](const Buckets& buckets) {
    Json out = Json::object();
    for (const auto& [name, kept] : buckets) out[name] = {{"measure", kept.measure}, {"case", case_tree(kept.c)}};
    return out;
  };
  Json changes = Json::array();
  for (const auto& [pair, count] : changes_) changes.push_back({pair.first, pair.second, count});
  return write_json({{"failures", tree_of(failures_)}, {"cases", tree_of(cases_)}, {"changes", changes}});
}

void Recorder::restore(const std::string& state) {
  const Json tree = read_json(state);
  const Field root(tree, "record");
  const auto buckets_in = [](const Field& object) {
    Buckets out;
    for (const auto& [name, kept] : object.members()) {
      if (!is_file_name(name)) kept.fail("is no name of a file");
      out[name] = {kept.member("measure").number(), case_in(kept)};
    }
    return out;
  };
  failures_ = buckets_in(root.member("failures"));
  cases_ = buckets_in(root.member("cases"));
  changes_.clear();
  for (const Field& change : root.member("changes").elements())
    changes_[{body_in(change, 0), body_in(change, 1)}] = change.element(2, 3, "numbers").count();
}

void Recorder::write(const std::filesystem::path& folder) const {
  for (const auto& [name, buckets] : {std::pair{"failures", &failures_}, std::pair{"cases", &cases_}}) {
    if (buckets->empty()) continue;
    std::filesystem::create_directories(folder / name);
    for (const auto& [bucket, kept] : *buckets)
      write_file(folder / name / (bucket + ".json"), format_case(kept.c) + "\n");
  }
}

}  // namespace plumb::scene
