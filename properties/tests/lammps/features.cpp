// LAMMPS's commands on plumb's bodies do what its manual says: by a number that is known, or the same on two processes as on one.
#include "properties/tests/lammps/crate.hpp"
#include "properties/tests/lammps/in_lammps.hpp"
#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

class InLammpsFeatures : public InLammps {
 protected:
  /// The last line of thermo, without step and atoms.
  [[nodiscard]] std::vector<double> last_of(const CrateScript& parts, const std::string& after,
                                            int processes = 1) const {
    const Ran ran = script(script_text(parts) + after, processes);
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    const auto table = thermo(ran.out);
    return table.empty() || table.back().size() < 3 ? std::vector<double>(20)
                                                    : std::vector(table.back().begin() + 2, table.back().end());
  }
  void expect_same_on_two_processes(const CrateScript& parts, const std::string& after) const {
    const Ran one = script(script_text(parts) + after);
    const std::string dump = read("dump.txt");
    const Ran two = script("processors 2 1 1\n" + script_text(parts) + after, 2);
    EXPECT_EQ(one.code, 0) << after << errors(one.out);
    EXPECT_EQ(two.code, 0) << after << errors(two.out);
    EXPECT_TRUE(read("dump.txt") == dump) << after << parts.before_motion;
  }
  void put(const Crate& crate) const { (void)file("data.txt", data_text(crate)); }
};

/// Each contact's forces are equal and opposite, and so is what LAMMPS adds all that is left of the momentum.
TEST_F(InLammpsFeatures, ForcesAddUpToMomentum) {
  put({});
  const char* const momentum = "v_px v_py v_pz";
  const std::string computes = "variable px equal mass(all)*vcm(all,x)\nvariable py equal mass(all)*vcm(all,y)\n"
                               "variable pz equal mass(all)*vcm(all,z)\n";
  const auto change = [&](const std::string& fix) {
    const CrateScript parts{.before_motion = computes + fix, .thermo = momentum};
    const auto before = last_of(parts, "run 0\n"), after = last_of(parts, "run 100\n");
    return Vec3<double>(after[0] - before[0], after[1] - before[1], after[2] - before[2]);
  };
  EXPECT_LT(change("").norm(), 1e-10);
  EXPECT_LT((change("fix push low addforce 1 2 3\n") - 0.1 * 16 * Vec3<double>(1, 2, 3)).norm(), 1e-9);
  const auto still = last_of(
      {.before_motion = computes + "fix still all momentum 10 linear 1 1 1\n", .thermo = momentum}, "run 100\n");
  EXPECT_LT(std::hypot(still[0], still[1], still[2]), 1e-10);
}

// Of bodies that touch nobody.
TEST_F(InLammpsFeatures, FrictionOfAFluidSlowsDown) {
  put({.spacing = 2});
  const CrateScript parts{.before_motion = "variable v atom vx\ncompute v all reduce max v_v\nvariable m atom mass\n"
                                           "compute m low reduce max v_m\nset group all d_n1 2\nset group all d_n2 2\n"
                                           "fix drag all viscous 1\n",
                          .thermo = "c_v c_m"};
  const auto before = last_of(parts, "run 0\n"), after = last_of(parts, "run 100\n");
  EXPECT_NEAR(after[0], before[0] * std::exp(-0.1 / before[1]), 2e-3 * before[0]);
}

// With dashpots, which come last.
TEST_F(InLammpsFeatures, ForcesAreReplacedAfterTheDashpots) {
  put({});
  const CrateScript parts{
      .before_motion =
          "variable f atom sqrt(fx*fx+fy*fy+fz*fz)\ncompute f low reduce max v_f\ncompute g high reduce max v_f\n",
      .thermo = "c_f c_g"};
  for (const char* fix : {"setforce 0 0 0", "freeze"}) {
    const auto last = last_of(parts, fmt::format("fix hold low {}\nrun 50\n", fix));
    EXPECT_EQ(last[0], 0) << fix;
    EXPECT_GT(last[1], 1) << fix;
  }
}

// Before the dashpots, as where they are not in the group that moves.
TEST_F(InLammpsFeatures, FrozenBodiesAreFixed) {
  put({});
  const std::string at_rest = "velocity low set 0 0 0\nset group low angmom 0 0 0\n";
  const auto fixed = last_of({.before_motion = at_rest, .group = "high"}, "run 50\n");
  EXPECT_EQ(last_of({.before_motion = at_rest + "fix hold low freeze\n"}, "run 50\n"), fixed);
  EXPECT_NE(last_of({.before_motion = at_rest}, "run 50\n"), fixed);
}

TEST_F(InLammpsFeatures, ExcludedPairsDoNotTouch) {
  put({.spacing = 0.8, .types = 2});
  EXPECT_EQ(last_of({}, "neigh_modify exclude group all all\nrun 50\n")[0], 0);
  EXPECT_GT(last_of({}, "neigh_modify exclude type 1 2\nrun 50\n")[0], 1);
}

TEST_F(InLammpsFeatures, ComputesThatReadEnergiesAndNeighbours) {
  put({});
  const auto last = last_of({.before_motion = "compute e all pair plumb/cn\ncompute n all coord/atom cutoff 1\n"
                                              "compute most all reduce max c_n\ncompute k all erotate/asphere\n"
                                              "set group all d_n1 2\nset group all d_n2 2\n",
                             .thermo = "pe c_e c_most c_k"},
                            "thermo_style custom step atoms pe c_e c_most c_k f_motion\n"
                            "thermo_modify norm no format float %.17g\nrun 50\n");
  EXPECT_EQ(last[0], last[1]);
  EXPECT_GT(last[0], 1);
  EXPECT_GE(last[2], 4);
  EXPECT_NEAR(last[3], last[4], 1e-12 * last[4]);
}

// What is beside plumb's forces is summed up with them, dashpots too.
TEST_F(InLammpsFeatures, BesideAnotherPairStyleThePressureIsWhole) {
  put({.types = 2});
  CrateScript parts{.before_motion = "compute s all stress/atom NULL virial\ncompute sum all reduce sum c_s[1] c_s[4]\n"
                                     "compute v all pressure NULL virial\n",
                    .thermo = "pe c_v[1] c_v[4] c_sum[1] c_sum[2] vol"};
  const auto alone = last_of(parts, "run 50\n");
  const std::string plumb =
      "plumb/cn accuracy 1e-4 linear.stiffness 1e3 damping.restitution 0.7 friction.coefficient 0.4";
  for (const std::string& pair :
       {"pair_style hybrid/overlay " + plumb + " lj/cut 1\npair_coeff * * plumb/cn\npair_coeff * * lj/cut 0 1\n",
        "pair_style hybrid " + plumb + "\npair_coeff * * plumb/cn\n"}) {
    parts.pair = pair;
    const auto both = last_of(parts, "run 50\n");
    for (std::size_t k = 0; k < alone.size(); ++k)
      EXPECT_NEAR(both[k], alone[k], 1e-13 * std::abs(alone[k])) << pair << k;
  }
  EXPECT_NEAR(alone[3], -alone[1] * alone[5], 1e-10 * std::abs(alone[3]));
  EXPECT_GT(alone[1], 1);
}

// Spheres of LAMMPS's own style and integrator between them, which they do not feel.
TEST_F(InLammpsFeatures, SpheresOfLammpsAreBesideThem) {
  put({.types = 2, .diameter = 0.9});
  const std::string laws = "linear.stiffness 1e3 damping.restitution 0.7 friction.coefficient 0.4";
  CrateScript parts{.before_motion = "group bodies type 1\ngroup spheres type 2\nset group spheres shape 0 0 0\n"
                                     "compute e all pair plumb/cn\nfix spheres spheres nve/sphere\n",
                    .group = "bodies",
                    .thermo = "c_e"};
  parts.style = "units lj\natom_style hybrid ellipsoid sphere\n";
  parts.pair = "pair_style hybrid plumb/cn accuracy 1e-4 " + laws +
               " gran/hertz/history 1e3 NULL 10 NULL 0.4 0\npair_coeff 1 1 plumb/cn\n"
               "pair_coeff 2 2 gran/hertz/history\npair_coeff 1 2 none\n";
  const auto with = last_of(parts, "run 100\n");
  const auto without = last_of(parts, "delete_atoms group spheres compress no\nrun 100\n");
  EXPECT_GT(with[0], 1);
  EXPECT_NEAR(with[0], without[0], 1e-9 * without[0]);
  expect_same_on_two_processes(parts, "run 100\n");
}

// What lists, shares and orders atoms in another way, or changes the step.
TEST_F(InLammpsFeatures, ARunIsTheSameOnTwoProcesses) {
  put({.types = 2});
  for (const char* settings :
       {"fix slow all dt/reset 10 1e-5 1e-3 0.002 units box\n", "neighbor 0.1 multi\ncomm_modify mode multi\n",
        "atom_modify sort 10 0.5\nneighbor 0.1 nsq\n", "fix even all balance 10 1.0 shift xy 5 1.0\n",
        "comm_style tiled\nbalance 1.0 rcb\n"})
    expect_same_on_two_processes({}, fmt::format("{}run 50\n", settings));
}

TEST_F(InLammpsFeatures, ASecondRunIsTheSameOnTwoProcesses) {
  put({.types = 2});
  // This LAMMPS reads past the end of a fix's section where it adds to atoms that are there.
  const std::string data = read("data.txt");
  (void)file("more.txt", data.substr(0, data.find("\nShapes")));
  for (const char* between :
       {"run 10 pre no\nrun 20 every 10 \"variable x equal 1\"\n", "delete_atoms group low compress no\n",
        "velocity low set 1 0 0\n", "set group low shape 0.9 0.9 0.5\nset group low d_n1 3\n",
        "displace_atoms low move 0.05 0 0\ndisplace_atoms high rotate 1 1 1 0 0 1 5\n",
        "change_box all x scale 1.05 xy delta 0.3 remap\n",
        "read_data more.txt add append shift 0 0 3.6 group more\nset group more d_n1 3 d_n2 4 d_density 2\n"})
    expect_same_on_two_processes({}, fmt::format("run 20\n{}run 30\n", between));
}

// The forces of its first step are done again, and no spring goes on for it.
TEST_F(InLammpsFeatures, ARunGoesOnFromStepsCountedAnew) {
  put({});
  const CrateScript parts{.pair =
                              "pair_style plumb/cn linear.stiffness 1e3 friction.coefficient 0.4 friction.damping 0.3\n"
                              "pair_coeff * *\n"};
  EXPECT_EQ(last_of(parts, "run 100\nreset_timestep 0\nrun 50\n"), last_of(parts, "run 100\nrun 50\n"));
}

// Of a shape that fix plumb/nve says, turned by where they are made; fix pour asks for spheres' diameters as well.
TEST_F(InLammpsFeatures, NewBodiesFall) {
  const CrateScript parts{.before_motion = "region top block 0.1 4.7 0.1 4.7 2 4.7\n"
                                           "fix more all deposit 9 1 10 321 region top near 0.7 vz -9 -9\n",
                          .new_bodies = "new 1 0.6 0.5 0.4 4 3 2"};
  put({.side = 3, .spacing = 1.6});
  expect_same_on_two_processes(parts, "run 150\n");
  double most = 0;  // of what contacts store
  const auto table = thermo(script(script_text(parts) + "thermo 5\nrun 150\n").out);
  for (const auto& row : table) most = std::max(most, row.at(2));
  EXPECT_EQ(table.back().at(1), 27 + 9);
  EXPECT_GT(most, 0);
  CrateScript poured{.before_motion =
                         "region top block 0 4.8 0 4.8 2 4.8 units box\nfix g all gravity 10 vector 0 0 -1\n"
                         "fix more all pour 9 1 321 region top diam one 0.8 dens 2 2\n",
                     .new_bodies = parts.new_bodies,
                     .style = "units lj\natom_style hybrid ellipsoid sphere\nboundary p p f\n"};
  put({.side = 3, .spacing = 1.6, .is_triclinic = false, .diameter = 1});
  expect_same_on_two_processes(poured, "run 150\n");
  EXPECT_EQ(last_of(poured, "thermo_style custom step atoms atoms\nrun 300\n")[0], 27 + 9);
}

TEST_F(InLammpsFeatures, FixedBodiesMoveAsTold) {
  put({});
  const CrateScript parts{.before_motion = "compute u all property/atom xu\ncompute x low reduce sum c_u\n",
                          .group = "high",
                          .thermo = "c_x"};
  CrateScript told = parts;
  told.before_motion += "fix go low move linear 0.5 0 0\n";
  EXPECT_NEAR(last_of(told, "run 100\n")[0] - last_of(parts, "run 0\n")[0], 16 * 0.05, 1e-12);
  expect_same_on_two_processes(told, "run 100\n");
}

}  // namespace
}  // namespace plumb::scene
