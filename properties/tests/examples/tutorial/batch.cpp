// A thousand pairs in one call: arrays in, arrays out.
#include <algorithm>
#include <iostream>
#include <plumb/batch/batch.hpp>
#include <vector>

int main() {
  const std::size_t n = 1000;
  const std::vector<double> one(n, 1), half(n, 0.5), zero(n, 0);
  std::vector<double> height(n), overlap(n);
  std::vector<plumb::Status> status(n);
  for (std::size_t i = 0; i < n; ++i) height[i] = 0.5 + 0.001 * static_cast<double>(i);

  plumb::PairArrays pairs;  // body 2 is turned about its x axis, and further from body 1 in each pair
  pairs.body1 = {.semi_axes = {one, one, half}, .position = {zero, zero, zero}, .quaternion = {one, zero, zero, zero}};
  pairs.body2 = {
      .semi_axes = {one, one, half}, .position = {zero, zero, height}, .quaternion = {one, half, zero, zero}};
  const plumb::BatchReport report = plumb::solve_batch(pairs, {}, {.status = status, .overlap = overlap});
  if (report.error != plumb::BatchError::none) return 2;  // a span has not the right length

  std::cout << std::ranges::count(status, plumb::Status::converged) << " converged, "
            << std::ranges::count_if(overlap, [](double o) { return o > 0; }) << " overlap\n";
}
