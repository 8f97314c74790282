// The two peers over libccd: one set of support functions, one reading of what it answers.
#pragma once

#include <ccd/ccd.h>

#include "solver/plumb_solver.h"

namespace plumb::peers {

/// ccdGJKPenetration or ccdMPRPenetration: 0 when the bodies overlap, -1 when they do not, -2 when memory fails.
using Penetration = int (*)(const void* body1, const void* body2, const ccd_t* settings, ccd_real_t* depth,
                            ccd_vec3_t* direction, ccd_vec3_t* position);

[[nodiscard]] int solve_with_libccd(const plumb_pair& pair, Penetration penetration, plumb_contact& contact);

void claim_libccd(const char* name, plumb_abilities& abilities);

}  // namespace plumb::peers
