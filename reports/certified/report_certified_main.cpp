// plumb report-certified; by their names also plumb report-certify-cost, plumb report-auto and plumb report-patch.
#include <array>
#include <string_view>

#include "reports/certified/parts.hpp"

int main(int argc, char** argv) {
  struct Part {
    std::string_view name;
    int (*run)(int argc, char** argv);
  };
  using namespace plumb::reports;
  constexpr std::array parts{Part{"report-certify-cost", report_certify_cost}, Part{"report-auto", report_auto},
                             Part{"report-patch", report_patch}};
  const std::string_view called = argc > 0 ? argv[0] : "";  // report-auto by plumb, .../plumb-report-auto by itself
  for (const Part& part : parts)
    if (called.ends_with(part.name)) return part.run(argc, argv);
  return report_certified(argc, argv);
}
