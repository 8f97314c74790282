// The bugs of a library of its own, after the sources that they are sown in: numbered from 0, and -1 for none.
#pragma once

#include <iterator>
#include <string_view>

namespace {

struct Row {
  std::string_view name;
  int number;
};

#define PLUMB_SEEDED_BUGS_MARK
// kRows and kTable, by seed.cmake.
#include "bugs.inc"

void select_bug(int bug) {
  plumb::bug_of_thread = bug < 0 ? 0 : kRows[bug].number;
}

}  // namespace

#define PLUMB_EXPORT extern "C" [[gnu::visibility("default")]]

PLUMB_EXPORT int seeded_count() {
  return static_cast<int>(std::size(kRows));
}
PLUMB_EXPORT const char* seeded_name(int bug) {
  return kRows[bug].name.data();
}
/// The rows as JSON.
PLUMB_EXPORT const char* seeded_table() {
  return kTable;
}
