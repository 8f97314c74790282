// A family for tests: unit spheres that overlap.
#include "properties/generators/draft.hpp"

namespace plumb::family {

void draw_dummy(Stream& stream, Draft& draft) {
  place_on_random_line(stream, draft, stream.log_uniform(1e-3, 0.1));
}

}  // namespace plumb::family
