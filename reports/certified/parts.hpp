// What the program plumb-report-certified is, each by a name of its own: the reference held against others, and others against it.
#pragma once

namespace plumb::reports {

/// What the reference proves, and whether anything found without it contradicts it.
[[nodiscard]] int report_certified(int argc, char** argv);
/// What a certificate costs.
[[nodiscard]] int report_certify_cost(int argc, char** argv);
/// Whether `auto` is ever wrong.
[[nodiscard]] int report_auto(int argc, char** argv);
/// Whether a patch is ever wrong.
[[nodiscard]] int report_patch(int argc, char** argv);

}  // namespace plumb::reports
