#include "properties/generators/paths.hpp"

#include <fmt/format.h>

namespace plumb {
namespace {

constexpr std::array all_paths{
    Path{"face_turn_8", "a block turns its face through exact parallelism with another's",
         [] { return motion::face_turn(8); }},
    Path{"face_turn_20", "the same with flatter faces", [] { return motion::face_turn(20); }},
    Path{"slide_over_edge_2.5", "a block slides across a face and over its edge, all rounded",
         [] { return motion::slide_over_edge(2.5); }},
    Path{"slide_over_edge_4", "the same, less rounded", [] { return motion::slide_over_edge(4); }},
    Path{"slide_over_edge_8", "the same with flat faces", [] { return motion::slide_over_edge(8); }},
    Path{"slide_over_edge_20", "the same with sharp edges", [] { return motion::slide_over_edge(20); }},
    Path{"slide_over_edge_50", "the same with sharper ones", [] { return motion::slide_over_edge(50); }},
    Path{"roll_through_tie_4",
         "equal cubic bodies; the lowest overlap goes from one axis to another as one of them turns",
         [] { return motion::roll_through_tie(4); }},
    Path{"roll_through_tie_8", "the same with flat faces", [] { return motion::roll_through_tie(8); }},
    Path{"slide_through_tie_4", "the same as one of them is shifted", [] { return motion::slide_through_tie(4); }},
    Path{"touch_and_part_2", "two ellipsoids touch through the smallest gaps, and part again",
         [] { return motion::touch_and_part(2); }},
    Path{"touch_and_part_6", "the same of two blocks", [] { return motion::touch_and_part(6); }},
    Path{"through_concentric_2", "a small ellipsoid passes through the centre of a larger one",
         [] { return motion::through_concentric(2); }},
    Path{"through_concentric_6", "the same of two blocks", [] { return motion::through_concentric(6); }},
    Path{"spin_about_axis_1.8",
         "a spheroid spins, its axis passes through the line of centres; coaxial, the tips touch",
         [] { return motion::spin_about_axis(1.8); }},
    Path{"spin_about_axis_1.45", "the same, deeper: coaxial, the nearest way out is sideways, any way",
         [] { return motion::spin_about_axis(1.45); }},
    Path{"spin_about_axis_0.6", "the same, deeper still", [] { return motion::spin_about_axis(0.6); }},
    Path{"needle_sweep", "a needle of aspect 1000 is swept across a disc's rim", motion::needle_sweep},
    Path{"far_jump_2", "an ellipsoid turns in small steps, and now and then far at once",
         [] { return motion::far_jump(2); }},
    Path{"far_jump_10", "the same of two blocks", [] { return motion::far_jump(10); }},
};

}  // namespace

std::span<const Path> paths() {
  return all_paths;
}

std::vector<Case> steps_of(const Path& path) {
  return steps_of(path.name, path.draw());
}

std::vector<Case> steps_of(std::string_view name, const std::vector<Draft>& drafts) {
  std::vector<Case> out;
  for (const Draft& draft : drafts) {
    Json provenance{{"path", name}, {"step", out.size()}, {"steps", drafts.size()}};
    provenance.update(draft.facts);
    out.push_back({fmt::format("{}-{:02}", name, out.size()), draft.pair, {}, std::move(provenance), {}});
  }
  return out;
}

std::string format_steps(const std::vector<Case>& steps) {
  std::string out;
  for (const Case& c : steps) out += format_case(c) + '\n';
  return out;
}

}  // namespace plumb
