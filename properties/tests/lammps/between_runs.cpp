// What may change between the runs of a script, and what contacts remember of it.
#include <fmt/format.h>

#include <numbers>

#include "properties/tests/lammps/in_lammps.hpp"

namespace plumb::scene {
namespace {

class BetweenRuns : public InLammps {
 protected:
  std::string style_ = "atom_style ellipsoid", box_ = "create_box 1 box";

  /// A box of 10 that is ready for balls of radius 0.5, of a density that lets nothing move them soon.
  [[nodiscard]] std::string head(const std::string& thermo_words) const {
    return "units lj\n" + style_ +
           "\nnewton off\ncomm_modify vel yes\nboundary f f f\nregion box block 0 10 0 10 0 10\n" + box_ +
           "\nfix shapes all property/atom d_n1 d_n2 d_density ghost yes\n"
           "pair_style plumb/cn accuracy 1e-6 linear.stiffness 1 friction.coefficient 0.5\npair_coeff * *\n"
           "neigh_modify every 1 delay 0 check yes\ntimestep 1e-3\nvariable still equal 1e12\n"
           "variable mass equal mass(all)\nvariable pull equal fcm(high,x)\nthermo_style custom step atoms " +
           thermo_words + "\nthermo_modify norm no format float %.17g lost ignore\n";
  }
  [[nodiscard]] std::vector<double> last_of(const std::string& thermo_words, const std::string& lines) const {
    const Ran ran = script(head(thermo_words) + lines);
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

TEST_F(BetweenRuns, AMassThatIsNotTheBodysIsReplacedAndSaid) {
  const std::string ready = ball(5, 5, 5, "low") + shape_all + "fix motion all plumb/nve\n";
  const std::string said = "1 masses were not d_density times the volume, and are now";
  for (const char* change : {"", "set group all density ${still}\n", "run 0\n"})
    EXPECT_EQ(script(head("pe") + ready + change + "run 0\n").out.find(said), std::string::npos) << change;
  const std::string changed = ready + "run 0\nset group all mass 3\nrun 0\n";
  EXPECT_NE(script(head("pe") + changed).out.find(said), std::string::npos);
  EXPECT_NEAR(last_of("v_mass", changed)[0], 1e12 * std::numbers::pi / 6, 1);
}

TEST_F(BetweenRuns, AfterClearTheStylesAreThere) {
  const std::string ready =
      ball(5, 5, 5, "low") + ball(5, 5, 5.9, "high") + shape_all + "fix motion all plumb/nve\nrun 10\n";
  const double once = last_of("pe", ready)[0];
  EXPECT_GT(once, 1e-3);
  EXPECT_EQ(last_of("pe", ready + "clear\n" + head("pe") + ready)[0], once);
}

// A bond between two that overlap may leave their contact out, and not a part of it.
TEST_F(BetweenRuns, BondsLeaveContactsOutOrNot) {
  style_ = "atom_style hybrid ellipsoid bond\nbond_style zero";
  box_ = "create_box 1 box bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 1\nbond_coeff *";
  const std::string ready = ball(5, 5, 5, "low") + ball(5, 5, 5.9, "high") + shape_all +
                            "special_bonds lj 1 1 1\ncreate_bonds single/bond 1 1 2\nfix motion all plumb/nve\n";
  EXPECT_NEAR(last_of("pe", ready + "run 0\n")[0], 0.005, 1e-6);
  EXPECT_EQ(last_of("pe", ready + "special_bonds lj 0 1 1\nrun 0\n")[0], 0);
  EXPECT_EQ(last_of("pe", ready + "special_bonds lj 0 1 1 coul 1 1 1\nrun 0\n")[0], 0);
  const Ran ran = script(head("pe") + ready + "special_bonds lj 0.5 1 1\nrun 0\n");
  EXPECT_NE(ran.out.find("a contact is there or not: special_bonds must be 0 or 1"), std::string::npos) << ran.out;
  EXPECT_NE(ran.code, 0);
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
