// The solver of shapes with its seeded bugs, beside `auto` in the same library (seeded_bugs.cpp).
#include "solver/method/convex.cpp"
#include "solver/shape/convex.cpp"
