// What may change between the runs of a script, and what contacts remember of it.
#include "properties/tests/lammps/in_lammps.hpp"

namespace plumb::scene {
namespace {

class BetweenRuns : public InLammps {
 protected:
  /// Balls of radius 0.5 and of a density that lets nothing move them soon, in a box of 10; `lines` set what else there is.
  [[nodiscard]] std::vector<double> last_of(const std::string& thermo_words, const std::string& lines) const {
    const Ran ran =
        script("units lj\natom_style ellipsoid\nnewton off\ncomm_modify vel yes\nboundary f f f\nregion box block 0 10 "
               "0 10 0 10\n"
               "create_box 1 box\nfix shapes all property/atom d_n1 d_n2 d_density ghost yes\n"
               "pair_style plumb/cn accuracy 1e-6 linear.stiffness 1 friction.coefficient 0.5\npair_coeff * *\n"
               "neigh_modify every 1 delay 0 check yes\nthermo_modify norm no format float %.17g\ntimestep 1e-3\n"
               "variable still equal 1e12\nvariable pull equal fcm(high,x)\nthermo_style custom step atoms " +
               thermo_words + "\nthermo_modify norm no format float %.17g lost ignore\n" + lines);
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    const auto table = thermo(ran.out);
    return table.empty() || table.back().size() < 3 ? std::vector<double>(9)
                                                    : std::vector(table.back().begin() + 2, table.back().end());
  }
  static std::string ball(double x, double y, double z, const std::string& group) {
    return fmt::format("create_atoms 1 single {} {} {}\nregion {}_at sphere {} {} {} 0.01\ngroup {} region {}_at\n", x,
                       y, z, group, x, y, z, group, group);
  }
  static constexpr const char* shape_all =
      "set group all shape 1 1 1\nset group all d_n1 2\nset group all d_n2 2\nset group all d_density ${still}\n";
};

// A piston's overlap is the way that it has come, in steps of two lengths.
TEST_F(BetweenRuns, TimeGoesOnWithAnotherStep) {
  const std::string ready = ball(5, 5, 5.5, "one") + shape_all +
                            "fix piston all plumb/wall 0 0 5 0 0 1 velocity 0 0 1\nfix motion all plumb/nve\n";
  const auto overlap = [&](const std::string& runs) { return std::sqrt(2 * last_of("pe", ready + runs)[0]); };
  EXPECT_NEAR(overlap("run 100\n"), 0.1, 1e-7);
  EXPECT_NEAR(overlap("run 100\ntimestep 2e-3\nrun 50\n"), 0.2, 1e-7);
  EXPECT_NEAR(overlap("fix reset all dt/reset 10 1e-3 2e-3 1 units box\nrun 100\n"), 0.2, 1e-7);
  EXPECT_NEAR(overlap("run 100\ntimestep 2e-3\nrun 10\nwrite_restart middle\nrun 40\n"), 0.2, 1e-7);
}

// One ball slides on another that is fixed, goes, and is made again where it was: with the same ID.
TEST_F(BetweenRuns, ANewAtomHasTouchedNobody) {
  const std::string ready = ball(5, 5, 5, "low") + ball(5, 5, 5.9, "high") + shape_all +
                            "velocity high set 0.1 0 0\nfix motion high plumb/nve\nrun 100\n";
  EXPECT_LT(last_of("v_pull", ready)[0], -1e-3);
  EXPECT_EQ(last_of("v_pull", ready + "delete_atoms group high compress no\ncreate_atoms 1 single 5 5 5.9\n" +
                                  shape_all + "group high subtract all low\nrun 0\n")[0],
            0);
}

// Another rubs on it, and slides: as hard as friction goes.
TEST_F(BetweenRuns, AFixedBodyTurnsAsTold) {
  const std::string ready = ball(5, 5, 5, "low") + ball(5, 5.9, 5, "high") + shape_all +
                            "fix turn low move rotate 5 5 5 0 0 1 1\nfix motion high plumb/nve\nrun 100\n";
  EXPECT_NEAR(last_of("v_pull", ready)[0], -0.5 * 0.1, 1e-4);
}

// The first of two walls goes; the other keeps what its contact remembers.
TEST_F(BetweenRuns, AWallIsKnownByItsId) {
  const std::string ready = ball(5, 5, 5.45, "high") + shape_all +
                            "velocity high set 0.1 0 0\nfix ceiling all plumb/wall 0 0 9 0 0 -1\n"
                            "fix floor all plumb/wall 0 0 5 0 0 1\nfix motion all plumb/nve\nrun 100\n";
  EXPECT_LT(last_of("v_pull", ready)[0], -1e-3);
  for (const char* runs : {"run 0\n", "run 50\n"})
    EXPECT_EQ(last_of("v_pull", ready + "unfix ceiling\n" + runs), last_of("v_pull", ready + runs)) << runs;
}

}  // namespace
}  // namespace plumb::scene
