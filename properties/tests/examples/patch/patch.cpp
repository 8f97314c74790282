// A die on a die, its tilt from next to nothing to minus that: the point of contact jumps, the patch does not.
#include <cstdio>
#include <plumb/method/automatic.hpp>
#include <plumb/patch/patch.hpp>

int main() {
  plumb::Pair dice;
  dice.body1.shape = dice.body2.shape = {{1, 1, 1}, 8, 8};
  dice.body2.position = {0, 0, 1.99};
  plumb::Want want;
  want.patch = true;
  plumb::Contact<double> contact[2];
  for (int i = 0; i < 2; ++i) {
    dice.body2.quaternion = {1, 0, i == 0 ? -5e-13 : 5e-13, 0};  // half the tilt, about y
    contact[i] = plumb::automatic<double>(dice, want, nullptr);
    if (contact[i].status != plumb::Status::converged) return 1;
    if (!(contact[i].patch->error < 0.01)) return 1;  // not as exact as it is wanted here
  }
  const plumb::Patch& patch = *contact[1].patch;
  std::printf("the point moves by %.3f, the patch by %.3f\n",
              (contact[1].contact_point - contact[0].contact_point).norm(),
              (patch.centre - contact[0].patch->centre).norm());
  std::printf("volume %.3f, area %.2f\n", patch.volume, patch.area);
  for (const plumb::Vec3<double>& at : plumb::points_of(patch))  // a quarter of the force each
    std::printf("a point %.2f from the middle\n", at.head<2>().norm());
}
