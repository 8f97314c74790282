// The main() of every test program: same seed, same cases, unless RC_PARAMS asks for others.
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  setenv("RC_PARAMS", "seed=20240229 max_success=200", 0);
  return RUN_ALL_TESTS();
}
