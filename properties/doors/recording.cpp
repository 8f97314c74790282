#include "properties/doors/recording.hpp"

#include <algorithm>

namespace plumb {

plumb_recorder_body recorder_body(const Body& body) {
  const auto& [shape, position, q] = body;
  return {{shape.semi_axes[0], shape.semi_axes[1], shape.semi_axes[2], shape.n1, shape.n2},
          {position[0], position[1], position[2], q[0], q[1], q[2], q[3]}};
}

plumb_recorder_answer recorder_answer(const Contact<double>& contact) {
  plumb_recorder_answer out{};
  out.touching = contact.verdict == Verdict::overlapping ? 1 : 0;
  out.overlap = contact.overlap;
  std::copy_n(contact.normal.data(), 3, out.normal);
  std::copy_n(contact.point1.data(), 3, out.points[0]);
  std::copy_n(contact.point2.data(), 3, out.points[1]);
  return out;
}

int record(plumb_recorder* recorder, const Pair& pair, const Contact<double>& contact) {
  const plumb_recorder_body body1 = recorder_body(pair.body1), body2 = recorder_body(pair.body2);
  const plumb_recorder_answer answer = recorder_answer(contact);
  return plumb_record(recorder, &body1, &body2, &answer);
}

FindingKind finding_kind(int recorded) {
  return finding_kind(std::string_view(plumb_recorder_finding_name(recorded))).value_or(FindingKind::none);
}

}  // namespace plumb
