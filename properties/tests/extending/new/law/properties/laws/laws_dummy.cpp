#include "properties/laws/laws_dummy.hpp"

namespace plumb::law {

Finding iterations_are_not_thirteen(const Evidence& e) {
  return {FindingKind::slow, e.answer.iterations == 13 ? 2.0 : 0.0, {}, "13 iterations"};
}

}  // namespace plumb::law
