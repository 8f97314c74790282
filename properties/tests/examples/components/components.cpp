// A word with each component of plumb: a pair solved, a batch of it, its proof, and a scene in time.
#include <plumb/batch/batch.hpp>
#include <plumb/method/automatic.hpp>
#include <plumb/plumb.h>
#include <plumb/reference/reference.hpp>
#include <plumb/scene/named.hpp>
#include <plumb/scene/simulation.hpp>

#include <iostream>

int main() {
  plumb::Pair pair;
  pair.body1.shape.semi_axes = {1, 1, 2};
  pair.body2.position = {1.5, 0, 0};
  const double overlap = plumb::automatic<double>(pair, {}, nullptr).overlap;
  std::cout << "solver     overlap " << overlap << '\n';

  const double one = 1, two = 2, zero = 0, apart = 1.5;
  double of_batch = 0;
  plumb::PairArrays pairs;
  pairs.body1 = {.semi_axes = {{{&one, 1}, {&one, 1}, {&two, 1}}},
                 .position = {{{&zero, 1}, {&zero, 1}, {&zero, 1}}},
                 .quaternion = {{{&one, 1}, {&zero, 1}, {&zero, 1}, {&zero, 1}}}};
  pairs.body2 = pairs.body1;
  pairs.body2.semi_axes[2] = {&one, 1};
  pairs.body2.position[0] = {&apart, 1};
  const plumb::BatchReport report = plumb::solve_batch(pairs, {}, {.overlap = {&of_batch, 1}});
  std::cout << "batch      " << (report.error == plumb::BatchError::none && of_batch == overlap ? "the same" : "other")
            << '\n';

  const plumb::Reference proof = plumb::find_reference(pair, plumb::Effort::proof);
  std::cout << "reference  unique: " << name(proof.unique) << ", lowest: " << name(proof.global) << '\n';

  std::cout << "c          version " << plumb_version() << '\n';
  plumb_certificate certificate{};
  certificate.size = sizeof certificate;
  const plumb_pair spheres = {
      {{{1, 1, 1}, {2, 2}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 1}, {2, 2}, {3, 0, 0}, {1, 0, 0, 0}}}};
  std::cout << "certify    "
            << (plumb_certify(&spheres, &certificate) == PLUMB_OK ? plumb_verdict_name(certificate.verdict) : "")
            << '\n';

  const plumb::scene::Scene scene = plumb::scene::named_scenes()[0].make(2);
  plumb::scene::Simulation run(scene, plumb::scene::make_plan(scene));
  for (int step = 0; step < 10; ++step) run.step();
  std::cout << "scene      " << scene.name << ", " << run.steps() << " steps\n";
}
