// What of LAMMPS does not go with plumb's bodies is refused in one line, and the program says so by its exit code.
#include "properties/tests/lammps/crate.hpp"
#include "properties/tests/lammps/in_lammps.hpp"

namespace plumb::scene {
namespace {

struct Refused {
  const char* lines;  ///< before fix plumb/nve
  const char* after;
  const char* words;  ///< of the one line
  const char* group = "all";
};

class InLammpsRefused : public InLammps {
 protected:
  void SetUp() override {
    InLammps::SetUp();
    if (!IsSkipped()) (void)file("data.txt", data_text({}));
  }
  void expect_refused(const Refused& what, CrateScript parts = {}) const {
    parts.before_motion = what.lines;
    parts.group = what.group;
    const Ran ran = script(script_text(parts) + what.after + "\nrun 1\n");
    EXPECT_NE(ran.code, 0) << what.lines << what.after;
    EXPECT_NE(ran.out.find(what.words), std::string::npos) << what.lines << what.after << errors(ran.out);
    const std::string said = errors(ran.out);  // MPI may have its own to say of an abort
    EXPECT_EQ(said.find("ERROR"), said.rfind("ERROR")) << said;
  }
};

TEST_F(InLammpsRefused, OtherFixesThatMoveBodies) {
  const char* const words = "moves atoms that fix plumb/nve moves, or of which it knows nothing";
  expect_refused({"fix other all nve\n", "", words});
  expect_refused({"fix other low nve/asphere\n", "", words, "high"});
  expect_refused({"fix other low rigid single\n", "", words, "high"});
  expect_refused({"fix other low move linear 1 0 0\n", "", words});
}

TEST_F(InLammpsRefused, ForcesReplacedBeforeDashpotsAdd) {
  for (const char* fix : {"setforce 0 0 0", "aveforce 0 0 0", "lineforce 1 0 0", "planeforce 1 0 0"})
    expect_refused({fmt::format("fix other low {}\n", fix).c_str(), "", "must stand after fix plumb/nve"});
  expect_refused({"", "fix other low addforce 1 0 0", "must stand after fix other: dashpots go by all other forces"});
}

TEST_F(InLammpsRefused, FormulasForEllipsoids) {
  expect_refused({"", "compute other all erotate/asphere",
                  "compute other: erotate/asphere takes bodies for ellipsoids: f_motion is their energy of turning"});
  expect_refused({"", "compute other all temp/asphere", "temp/asphere takes bodies for ellipsoids"});
  expect_refused({"fix other all langevin 1 1 1 123 angmom 3.333\n", "", "langevin takes bodies for ellipsoids"});
}

TEST_F(InLammpsRefused, WhatNeedsTheForceOfAPairAlone) {
  expect_refused({"", "compute other all contact/atom", "Compute contact/atom requires atom style sphere"});
  expect_refused({"", "compute other all pair/local force\ndump other all local 1 d index c_other",
                  "Pair style does not support compute pair/local"});
  expect_refused({"", "compute other all group/group all", "Pair style does not support compute group/group"});
  expect_refused({"", "variable q equal 1\nfix other all adapt 1 pair plumb/cn linear.stiffness * * v_q",
                  "Fix adapt pair style param not supported", "all"});
  expect_refused({"", "kspace_style ewald 1e-4", "Kspace style requires atom attribute q"});
  expect_refused(
      {"region r block 0 1 0 1 0 1\nfix other all gcmc 1 1 0 1 123 1 1 1\n", "", "gcmc takes atoms for points"});
}

// The pair style that it asked for its moments of inertia is no more.
TEST_F(InLammpsRefused, TheEnergyOfTurningAfterAnotherPairStyle) {
  for (const char* after : {"", "run 1\npair_style zero 1\npair_style plumb/cn linear.stiffness 1\npair_coeff * *\n"})
    expect_refused(
        {"", fmt::format("{}print \"$(f_motion)\"", after).c_str(), "f_motion is there once a run was prepared"});
}

TEST_F(InLammpsRefused, AtomsThatAreMultiplied) {
  expect_refused({"", "replicate 2 1 1", "Cannot replicate with fixes that store atom quantities"});
}

TEST_F(InLammpsRefused, SettingsThatLeaveContactsOut) {
  expect_refused({"pair_modify compute no\n", "", "cannot be left out: no `pair_modify compute no`"});
  expect_refused({"atom_modify first low\ncomm_modify group low\n", "", "needs the ghosts of all atoms"});
  expect_refused({"run_style respa 2 2 pair 1\n", "", "needs run_style verlet"});
  expect_refused({"", "minimize 0 0 1 1", "cannot minimize"});
  expect_refused({"", "", "needs three dimensions"}, {.style = "units lj\natom_style ellipsoid\ndimension 2\n"});
}

TEST_F(InLammpsRefused, WallsThatThePeriodicBoxWouldRepeat) {
  expect_refused({"fix floor all plumb/wall 0 0 0 0 0 1\n", "",
                  "fix floor: plumb/wall is a plane across an axis along which the box is periodic"});
  const auto said = [&](const std::string& at) {
    return script(script_text({.before_motion = "fix room all plumb/wall box " + at + " 1 0 0 0 1 1 1 outside\n"}) +
                  "run 0\n")
        .out.find("fix room: plumb/wall is there once: a periodic border does not repeat it");
  };
  EXPECT_EQ(said("1.8 1.8 1.8"), std::string::npos);
  EXPECT_NE(said("1.8 1.7 3"), std::string::npos);
  expect_refused({"fix floor all wall/harmonic zlo 0 1 1 0.5\n", "", "Cannot use fix wall in periodic dimension"});
}

TEST_F(InLammpsRefused, NewAtomsWithoutAShape) {
  expect_refused({"region r block 0 3 0 3 0 3\n", "create_atoms 1 single 1 1 1", "atom 65 has no shape"});
  expect_refused({"region r block 0 3 0 3 0 3\n", "fix other all deposit 1 1 1 123 region r", "atom 65 has no shape"});
  expect_refused(
      {"region r block 0 3 0 3 0 3\n", "fix other all pour 1 1 1 region r", "requires atom attributes radius"});
}

// Atoms that were there before have left their shapes where ghosts come to lie.
TEST_F(InLammpsRefused, GhostsWithShapesOfOthers) {
  CrateScript parts;
  parts.read = "fix shapes all property/atom d_n1 d_n2 d_density\nread_data data.txt fix shapes NULL Shapes\n";
  (void)file("data.txt", data_text({.side = 6}));
  expect_refused({"", "group many id > 20\ndelete_atoms group many compress no",
                  "has not its shape as a ghost: fix property/atom needs `ghost yes`"},
                 parts);
}

TEST_F(InLammpsRefused, NewBodiesThatAreNone) {
  const auto refused = [&](const std::string& words, const char* reason) {
    expect_refused({"", "", reason}, {.new_bodies = words});
  };
  refused("old", "fix plumb/nve: old: is none of its arguments: new");
  refused("new 1 1 1 1 4", "new: needs a type, 3 diameters, 2 exponents, a density");
  refused("new 2 1 1 1 4 4 1", "new: needs one of the 1 types of atoms");
  refused("new 1 1 1 1 0.5 4 1", "exponents[0]: must be finite and above 1");
  refused("new 1 1 1 1 4 4 0", "new: needs a density that is a positive number");
}

TEST_F(InLammpsRefused, TimeSetBackUnderAMovingWall) {
  CrateScript parts;
  parts.style += "boundary f f f\n";
  expect_refused({"fix floor all plumb/wall 0 0 -9 0 0 1 velocity 0 0 1\n", "run 1\nreset_timestep 0",
                  "Cannot reset timestep with a time-dependent fix defined"},
                 parts);
}

TEST_F(InLammpsRefused, StylesThatAreOnlyScaled) {
  CrateScript parts;
  parts.pair = "pair_style hybrid/scaled 0.5 plumb/cn linear.stiffness 1e3\npair_coeff * * plumb/cn\n";
  expect_refused({"", "", "has forces that pair_style hybrid/scaled cannot scale"}, parts);
}

}  // namespace
}  // namespace plumb::scene
