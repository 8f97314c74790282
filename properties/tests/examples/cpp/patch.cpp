// A die on a die, tilted by next to nothing: the point of contact jumps, the patch does not.
#include <iostream>
#include <plumb/method/automatic.hpp>
#include <plumb/patch/patch.hpp>

int main() {
  plumb::Pair dice;
  dice.body1.shape = dice.body2.shape = {{1, 1, 1}, 8, 8};
  dice.body2.position = {0, 0, 1.99};
  plumb::Want want;
  want.patch = true;
  for (const double tilt : {-1e-12, 1e-12}) {
    dice.body2.quaternion = {1, 0, tilt / 2, 0};  // about y
    const plumb::Contact<double> contact = plumb::automatic<double>(dice, want, nullptr);
    if (contact.status != plumb::Status::converged) return 1;
    const plumb::Patch& patch = contact.patch.value();
    if (!(patch.error < 0.01)) return 1;  // not as exact as it is wanted here
    std::cout.precision(2);
    std::cout << "point at x = " << contact.contact_point.x() << ", patch at x = " << patch.centre.x() << '\n';
    std::cout << "  volume " << patch.volume << ", area " << patch.area << '\n';
    for (const plumb::Vec3<double>& at : plumb::points_of(patch))  // a quarter of the force each
      std::cout << "  a point " << at.head<2>().norm() << " from the middle\n";
  }
}
