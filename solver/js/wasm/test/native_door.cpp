// The door without WebAssembly: blocks of doubles from standard input, (method, inputs) each, to blocks of outputs.
// compare.mjs holds the package to it. Undiagnosed: the 17 outputs of a contact.
#include <algorithm>
#include <array>
#include <cstdio>

extern "C" {
double* plumb_js_block();
void plumb_js_solve(int method, int diagnosed, int iteration_limit, double tolerance);
}

namespace {

constexpr std::size_t inputs = 27, outputs = 17;
constexpr int iteration_limit = 100;  // the package's own

}  // namespace

int main() {
  std::array<double, 1 + inputs> given;
  while (std::fread(given.data(), sizeof(double), given.size(), stdin) == given.size()) {
    double* const block = plumb_js_block();
    std::copy(given.begin() + 1, given.end(), block);
    plumb_js_solve(static_cast<int>(given[0]), 0, iteration_limit, 0);
    if (std::fwrite(block + inputs, sizeof(double), outputs, stdout) != outputs) return 2;
  }
  return 0;
}
