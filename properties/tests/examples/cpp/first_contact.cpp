// The contact of an ellipsoid with a rounded box, by the solver to use.
#include <iostream>
#include <plumb/method/automatic.hpp>

int main() {
  plumb::Pair pair;
  pair.body1.shape.semi_axes = {1, 0.7, 0.5};
  pair.body2.shape = {{0.5, 0.5, 0.4}, 8, 8};  // semi-axes, then the exponents n1, n2: nearly a box
  pair.body2.position = {0.9, 0.2, 0.7};       // world frame, the unit of the semi-axes
  pair.body2.quaternion = {0.9, 0.3, 0, 0.1};  // (w, x, y, z), of any length

  const plumb::Want want;  // overlap, normal and points
  const plumb::Contact<double> contact = plumb::automatic<double>(pair, want, nullptr);
  std::cout << name(contact.status) << ", " << name(contact.verdict) << '\n';
  if (contact.status != plumb::Status::converged) return 1;  // there is no answer, and no number of it is one
  std::cout << "overlap " << contact.overlap << "\nnormal " << contact.normal.transpose() << '\n';

  // A step later: from where the last solve ended.
  pair.body2.position.z() -= 0.01;
  const plumb::Contact<double> next = plumb::automatic<double>(pair, want, &contact);
  std::cout << "a step later " << next.overlap << ", " << next.iterations << " iterations\n";
}
