// A law for tests.
#pragma once

#include "properties/laws/laws.hpp"

namespace plumb::law {

[[nodiscard]] Finding iterations_are_not_thirteen(const Evidence& e);

}  // namespace plumb::law
