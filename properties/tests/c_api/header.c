/* plumb.h is C: this file is compiled as C99 with all warnings as errors. */
#include "solver/plumb.h"

int header_is_c(void) {
  plumb_options options = PLUMB_OPTIONS;
  return options.method == NULL && options.want == PLUMB_WANT_CONTACT;
}
