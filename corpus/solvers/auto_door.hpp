// `auto` behind the C door, in one compilation, contact.cpp and all: what libraries that hold it built otherwise share
// (reports/stability/variants.cmake: other compilers and options; fuzz/bugs: with a mistake in it).
#pragma once

#include "solver/c/auto_door.hpp"
#include "solver/contact.cpp"
#include "solver/least_squares_impl.hpp"
#include "solver/method/auto/automatic_impl.hpp"
#include "solver/patch/patch.cpp"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(double)
PLUMB_INSTANTIATE_LEAST_SQUARES(double)

}  // namespace plumb
