#include "fuzz/peers/shape_peers.hpp"

#include "fuzz/peers/shape_peers_impl.hpp"

namespace plumb::peers {

std::vector<Solver> shape_peers() {
  std::vector<Solver> out;
  [[maybe_unused]] const auto add = [&](const char* name, SolveShapes* solve) {
    Solver& solver = out.emplace_back();
    solver.name = name;
    solver.published = true;
    solver.solve_convex = [solve](const ConvexPair& pair, const Want&, const Contact<double>*) { return solve(pair); };
  };
#if defined(PLUMB_HAS_LIBCCD)
  add("peer_libccd_epa", libccd_epa);
#endif
#if defined(PLUMB_HAS_FCL)
  add("peer_fcl", fcl_epa);
  add("peer_fcl_box_box", fcl_box_box);
#endif
  return out;
}

}  // namespace plumb::peers
