/* The flight recorder as its users compile it: the one file with the implementation. */
#define PLUMB_RECORDER_IMPLEMENTATION
#include "solver/plumb_recorder.h"
