// The methods by name, for the sources that instantiate them.
#pragma once

#include <array>

#include "reports/precision_methods.hpp"
#include "solver/method/automatic.hpp"
#include "solver/method/common_normal.hpp"
#include "solver/method/first_touch.hpp"
#include "solver/method/geometric_potential.hpp"
#include "solver/method/minimum_distance.hpp"

namespace plumb::reports {

template <class S>
[[nodiscard]] SolveFunction<S> find_in_table(std::string_view method) {
  struct Row {
    std::string_view name;
    SolveFunction<S> solve;
  };
  const std::array rows{Row{"auto", automatic_in_callers_mode<S>},
                        Row{"original_cn", original_cn<S>},
                        Row{"corrected_cn", corrected_cn<S>},
                        Row{"new_cn", new_cn<S>},
                        Row{"minimum_distance", minimum_distance<S>},
                        Row{"geometric_potential", geometric_potential<S>},
                        Row{"geometric_potential_midway", geometric_potential_midway<S>},
                        Row{"first_touch", undone_motion<S>}};
  for (const Row& row : rows)
    if (row.name == method) return row.solve;
  return nullptr;
}

}  // namespace plumb::reports
