#define PLUMB_RECORDER_IMPLEMENTATION
#include "solver/plumb_recorder.h"
