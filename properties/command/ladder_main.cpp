// plumb ladder: the hard cases, each ladder step by step; --write freezes them with what is certified of each.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <thread>

#include "corpus/case/case.hpp"
#include "corpus/certificate/certificate.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/in_parallel.hpp"
#include "corpus/command/interrupt.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/families_shapes.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb {
namespace {

constexpr int kDigits = 50;

struct Options {
  std::string ladder, folder;
  int step = 0;
  std::uint64_t seed = 1, index = 0, variants = 2;
};

std::vector<std::string> all_ladders() {
  const auto names = hard_generators();
  return {names.begin(), names.end()};
}

/// Those of shapes too: they are named, and not among all.
std::vector<std::string> known_ladders() {
  std::vector<std::string> out = all_ladders();
  for (const ShapeFamily& family : shape_families())
    if (!family.steps.empty()) out.emplace_back(family.name);
  return out;
}

std::size_t count_steps(const std::string& ladder) {
  const ShapeFamily* const of_shapes = find_shape_family(ladder);
  return of_shapes != nullptr ? of_shapes->steps.size() : ladder_steps(ladder).size();
}

Case case_of(const std::string& ladder, std::size_t step, std::uint64_t seed, std::uint64_t variant) {
  const ShapeFamily* const of_shapes = find_shape_family(ladder);
  if (of_shapes == nullptr) return ladder_case(ladder, step, seed, variant);
  return generate(*of_shapes, seed, variant * of_shapes->steps.size() + step);
}

void declare(CommandLine& app, Options& options) {
  app.add_option("LADDER", options.ladder, "one ladder (plumb families lists them); all without")
      ->is_one_of("ladder", known_ladders());
  app.add_option("--step", options.step, "one step, from 1; all without")->in_range(1, 1000);
  declare_seed(app, options.seed);
  auto* index =
      app.add_option("--index", options.index, "which variant is printed")->capture_default_str()->check(refuse_seed);
  auto* write = app.add_option("--write", options.folder,
                               "certify the cases and write each ladder to this folder, one file each");
  app.add_option("--variants", options.variants, "how many cases of each step, with --write")
      ->capture_default_str()
      ->check(refuse_count)
      ->needs(write)
      ->excludes(index);
}

/// The numbers 0 .. of the steps that were asked for.
std::vector<std::size_t> steps_of(const std::string& ladder, const Options& options) {
  const std::size_t count = count_steps(ladder);
  const auto one = static_cast<std::size_t>(options.step);
  if (one > count) throw InputFailure("--step", 0, "", fmt::format("{} has {} steps", ladder, count));
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i)
    if (one == 0 || one == i + 1) out.push_back(i);
  return out;
}

std::vector<std::string> ladders_of(const Options& options) {
  return options.ladder.empty() ? all_ladders() : std::vector{options.ladder};
}

Json certificate_of(const Pair& pair, const Reference& found) {
  Json out = Json::object();
  put_reference(out, found, kDigits);
  if (found.common_normal.solved) put_condition_claims(out, pair, found.common_normal);
  return out;
}

/// What any right answer in double gives: the verdict where the overlap is above every rounding floor, and the overlap to 13 digits
/// of the size, or of itself where the bodies are further apart.
Expect expectation(const Pair& pair, const Reference& found) {
  Expect expect;
  if (found.global != Claim::proved) return expect;
  const double lower = static_cast<double>(found.overlap.lower), upper = static_cast<double>(found.overlap.upper);
  const double steps = 8 * std::numeric_limits<double>::denorm_min();  // between subnormal numbers
  const double allowed = 1e-13 * std::max(size_of(pair), std::abs(lower)) + steps;
  if (std::min(std::abs(lower), std::abs(upper)) > allowed) expect.verdict = name(found.verdict);
  expect.overlap = {lower - allowed, upper + allowed};
  return expect;
}

/// Of shapes the verdict and the overlap alone are proved.
Expect expectation(const ConvexPair& pair) {
  const Vec3<double> unknown = Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  const reference::ConvexBounds found = reference::bound_overlap(pair, unknown, kConvexCells);
  const double allowed = 1e-12 * std::max(size_of(pair), std::abs(found.lower));
  Expect expect;
  if (found.lower > allowed) expect.verdict = name(Verdict::overlapping);
  if (found.upper < -allowed) expect.verdict = name(Verdict::separated);
  expect.overlap = {found.lower - allowed, found.upper + allowed};
  return expect;
}

Case frozen(Case c) {
  if (c.convex) {
    c.expect = expectation(*c.convex);
    return c;
  }
  const Reference found = find_reference(c.pair, Effort::digits);
  c.expect = expectation(c.pair, found);
  c.provenance["certificate"] = certificate_of(c.pair, found);
  return c;
}

/// One file, its lines in the order of the steps.
std::string frozen_ladder(const std::string& ladder, const Options& options) {
  std::vector<Case> cases;
  for (const std::size_t step : steps_of(ladder, options))
    for (std::uint64_t i = 0; i < options.variants; ++i) cases.push_back(case_of(ladder, step, options.seed, i));
  in_parallel(cases.size(), std::max(1u, std::thread::hardware_concurrency()),
              [&](std::size_t i) { cases[i] = frozen(cases[i]); });
  std::string text;
  for (const Case& c : cases) text += format_case(c) + "\n";
  return text;
}

void freeze(const Options& options) {
  std::error_code failed;
  std::filesystem::create_directories(options.folder, failed);
  if (failed) fail_with(options.folder, failed.value());
  for (const std::string& ladder : ladders_of(options)) {
    const std::string text = frozen_ladder(ladder, options);
    if (interrupted()) return;
    const std::filesystem::path file = std::filesystem::path(options.folder) / (ladder + ".jsonl");
    write_file(file, text);
    print_line(file.string());
  }
}

int run(const Options& options) {
  if (!options.folder.empty()) {
    freeze(options);
    return exit_done;
  }
  for (const std::string& ladder : ladders_of(options))
    for (const std::size_t step : steps_of(ladder, options))
      print_line(format_case(case_of(ladder, step, options.seed, options.index)));
  return exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  plumb::CommandLine app("The hard cases, step by step.", "plumb ladder");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::run(options); });
}
