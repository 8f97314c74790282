// What the library of seeded bugs exports beside the C door, for who is built from the same sources and by the same compiler
// (reports/kills/): the door knows no warm start that `auto` would follow, and no answer but the whole one.
#pragma once

#include "solver/shape/convex.hpp"

/// In its binary, and in no program's: properties/tests/reports looks for it.
#define PLUMB_SEEDED_BUGS_MARK "plumb: this solver has seeded bugs"

extern "C" {

/// The rows of fuzz/bugs/*.json, an array of JSON, after a line with the mark.
[[nodiscard]] const char* plumb_seeded_bug_table();

/// From now on this thread's solves have that bug; "none": none. 0, or 1 for an unknown name.
[[nodiscard]] int plumb_seeded_bug_select(const char* name);

/// `auto`.
void plumb_seeded_bug_solve(const plumb::Pair& pair, const plumb::Want& want, const plumb::Contact<double>* last,
                            plumb::Contact<double>& out);

/// The same of two bodies of any shapes, without a contact before.
void plumb_seeded_bug_solve_convex(const plumb::ConvexPair& pair, const plumb::Want& want, plumb::Contact<double>& out);
}
