// References that the tests of a build prove once: a second run, and a second test of the same pair, find them.
#pragma once

#include "corpus/certificate/reference_store.hpp"
#include "properties/tests/draws.hpp"

namespace plumb {

/// From the build's own folder by day, proved anew at night. Entries are of this build's reference alone (reference_store.hpp).
inline ReferenceSource kept_references() {
  return is_nightly() ? ReferenceSource{} : references_of(open_store(PLUMB_BINARY_DIR "/test_references"));
}

}  // namespace plumb
