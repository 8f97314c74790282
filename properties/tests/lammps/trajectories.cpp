// One scene by plumb and by LAMMPS on 1, 2 and 4 processes: the same trajectory.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "properties/tests/lammps/in_lammps.hpp"
#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/crowded_box.hpp"

namespace plumb::scene {
namespace {

/// Steps at which anything presses on anything.
std::int64_t pressing_steps(const Scene& scene) {
  const auto run = made::started(scene);
  std::int64_t steps = 0;
  for (; !run->is_done(); run->step()) steps += run->world().contacts.pressing.empty() ? 0 : 1;
  return steps;
}

/// So long and so often written that ranks which share a processor are done in seconds.
void run_for(Scene& scene, double time_step, int steps) {
  scene.run.time_step = time_step;
  scene.run.duration = time_step * steps;
  scene.run.outputs = {.every = time_step * steps / 5};
}

// What finds two trajectories the same, or not.
TEST(Deviations, AreLargestOverTheBodiesAndRelativeToTheScene) {
  Scene scene;
  scene.bodies = {made::body({{1, 2, 4}, 2, 2}, {0, 0, 0}), made::ball(1, {9, 0, 0})};
  Frame frame{{{0, 0, 0}, {9, 0, 0}}, {{0, 0, 0}, {0, 5, 0}}, {{1, 0, 0, 0}, {1, 0, 0, 0}}}, other = frame;
  other.position[1].x() += 0.04;
  other.velocity[0].z() -= 0.1;
  other.quaternion[1][3] = 0.003;
  const auto apart = deviations(scene, {{0, frame}, {7, frame}}, {{7, other}, {8, other}});
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_NEAR(apart.at(7).position, 0.01, 1e-15);
  EXPECT_NEAR(apart.at(7).velocity, 0.02, 1e-15);
  EXPECT_EQ(apart.at(7).orientation, 0.003);
}

TEST_F(InLammps, AnImpactOfTwoSuperquadricsIsTheSameToTheBit) {
  Scene scene;
  scene.name = "impact";
  scene.bodies = {made::body({{1, 0.8, 0.6}, 4, 3}, {-0.9, 0.1, 0.2}, {1, 0, 0}),
                  made::body({{0.7, 0.9, 1.1}, 2.5, 6}, {0.9, -0.2, 0.1}, {-1, 0, 0.1})};
  scene.bodies[1].body.quaternion = {0.9, 0.1, -0.3, 0.2};
  scene.effects.linear = Linear{2e4};
  scene.effects.damping = Damping{0.6};
  scene.effects.friction = Friction{0.3};
  run_for(scene, 1e-3, 250);
  EXPECT_GT(pressing_steps(scene), 10);
  EXPECT_EQ(largest_deviation(scene, {1, 2, 4}), 0);
}

// The lists of neighbours are others, and with them where a contact's first solve starts.
TEST_F(InLammps, ACrowdWithAllEffectsIsTheSameToTheSolversTolerance) {
  Scene scene = without(crowd(), Conduction::name);
  scene.run.accuracy = 1e-5;
  run_for(scene, 5e-4, 300);
  EXPECT_GT(pressing_steps(scene), 25);
  EXPECT_LT(largest_deviation(scene, {1, 2}), 1e-9);
}

// Contacts reach through its sides; no centre leaves it.
TEST_F(InLammps, APeriodicBoxThatStays) {
  Scene scene = without(made::crowded_box(), Conduction::name);
  scene.run.accuracy = 1e-5;
  run_for(scene, 5e-4, 200);
  EXPECT_GT(pressing_steps(scene), 25);
  EXPECT_LT(largest_deviation(scene, {1, 2}), 1e-9);
}

TEST_F(InLammps, HertzAndFixedBodies) {
  Scene scene;
  scene.name = "hertz";
  scene.bodies = {made::body({{2, 2, 0.5}, 6, 6}, {0, 0, 0}), made::body({{0.6, 0.5, 0.4}, 3, 2}, {0.2, 0, 0.95}),
                  made::ball(0.4, {-0.9, 0, 0.88})};
  scene.bodies[0].is_fixed = true;
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.hertz = Hertz{1e5};
  scene.effects.damping = Damping{0.5};
  scene.effects.friction = Friction{0.4};
  run_for(scene, 1e-3, 250);
  EXPECT_GT(pressing_steps(scene), 25);
  EXPECT_EQ(largest_deviation(scene, {1, 2}), 0);
}

// Balls of glass and of steel, one of them fixed, on a rigid floor; between the two what mixing does not give.
TEST_F(InLammps, Materials) {
  Scene scene;
  scene.name = "materials";
  scene.bodies = {made::ball(0.5, {0, 0, 0.499}), made::body({{0.6, 0.5, 0.4}, 3, 2}, {0.2, 0, 1.35}),
                  made::ball(0.4, {-0.85, 0, 0.39})};
  scene.bodies[1].material = scene.bodies[2].material = 1;
  scene.bodies[2].is_fixed = true;
  scene.walls = {made::floor_at()};
  scene.walls[0].material = 2;
  scene.materials = {{.name = "glass", .density = {}, .is_rigid = false, .effects = {}},
                     {.name = "steel", .density = {}, .is_rigid = false, .effects = {}},
                     {.name = "floor", .density = {}, .is_rigid = true, .effects = {}}};
  scene.materials[0].effects.hertz = Hertz{7e4, 0.2};
  scene.materials[1].effects.hertz = Hertz{2e5, 0.3};
  scene.materials[0].effects.friction = Friction{0.3};
  scene.materials[2].effects.friction = Friction{0.5};
  scene.material_pairs = {{{0, 1}, {}}};
  scene.material_pairs[0].effects.friction = Friction{0.2};
  scene.effects.damping = Damping{0.6};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  run_for(scene, 1e-3, 250);
  EXPECT_GT(pressing_steps(scene), 25);
  EXPECT_EQ(largest_deviation(scene, {1, 2}), 0);
}

// Far from the origin and alone: where an atom is says nothing of where it will be.
TEST_F(InLammps, OneBallOfAMaterialMeetsAWallFarAway) {
  Scene scene;
  scene.name = "one";
  scene.bodies = {made::ball(0.5, {0, 0, -9.45}, {0, 0, -1})};
  scene.walls = {made::floor_at(-10)};
  scene.materials = {{.name = "glass", .density = {}, .is_rigid = false, .effects = {}}};
  scene.materials[0].effects.hertz = Hertz{7e4, 0.2};
  run_for(scene, 1e-3, 250);
  EXPECT_GT(pressing_steps(scene), 5);
  EXPECT_EQ(largest_deviation(scene, {1}), 0);
}

// With what friction remembers of a patch's turning.
TEST_F(InLammps, LawsOnPatches) {
  Scene scene;
  scene.name = "patches";
  scene.bodies = {made::body({{1, 1, 0.5}, 6, 6}, {0, 0, 0.48}), made::body({{0.6, 0.5, 0.4}, 4, 4}, {0.2, 0, 1.36})};
  scene.bodies[1].angular_velocity = {0, 0, 2};
  scene.walls = {made::floor_at()};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.damping = Damping{0.5};
  scene.effects.friction = Friction{0.4};
  run_for(scene, 1e-3, 150);
  Scene volume = scene;
  volume.effects.volume = Volume{1e4, 1.5};
  scene.effects.foundation = Foundation{1e4};
  for (const Scene& each : {scene, volume}) {
    EXPECT_GT(pressing_steps(each), 10);
    EXPECT_EQ(largest_deviation(each, {1, 2}), 0);
  }
}

// Of bodies that touch each other, walls, and across the border of two processes.
TEST_F(InLammps, EnergiesOfAtomsSumUpToThatOfAll) {
  Scene scene = without(crowd(), Conduction::name);
  run_for(scene, 5e-4, 300);
  export_to(path_ / "scene", scene, make_plan(scene));
  const std::string script = read("scene/in.lammps"), run_line = script.substr(script.rfind("run "));
  (void)file("scene/in.lammps", script.substr(0, script.rfind("run ")) + R"--(compute each all pe/atom
compute sum all reduce sum c_each
thermo_modify norm no
fix sums all print 60 "$(pe:%.17g) $(c_sum:%.17g)" file sums.txt title ""
)--" + run_line);
  for (const int count : {1, 2}) {
    ASSERT_TRUE(run_lammps(path_ / "scene", lammps_program, count)) << read("scene/log." + std::to_string(count));
    std::istringstream in(read("scene/sums.txt"));
    int pressed = 0;
    for (double all = 0, sum = 0; in >> all >> sum; pressed += all != 0 ? 1 : 0)
      EXPECT_NEAR(sum, all, 1e-10 * std::abs(all));
    EXPECT_GT(pressed, 1);
  }
}

// No walls, and no body near the border: -3 p V is the sum of position times force. Two processes share the contacts.
TEST_F(InLammps, PressureAndStressAreThoseOfTheContactForces) {
  Scene scene = without(without(without(crowd(), Conduction::name), Gravity::name), Drag::name);
  scene.effects.moving_walls.reset();
  scene.walls.clear();
  run_for(scene, 5e-4, 300);
  export_to(path_ / "scene", scene, make_plan(scene));
  const std::string script = read("scene/in.lammps"), run_line = script.substr(script.rfind("run "));
  (void)file("scene/in.lammps", script.substr(0, script.rfind("run ")) + R"--(compute p all pressure NULL virial
compute s all stress/atom NULL virial
compute sums all reduce sum c_s[1] c_s[2] c_s[3] c_s[4]
variable w atom x*fx+y*fy+z*fz
variable xy atom x*fy
compute w all reduce sum v_w v_xy
thermo_modify norm no
fix p all print 60 "$(-3*vol*c_p:%.17g) $(c_sums[1]+c_sums[2]+c_sums[3]:%.17g) $(c_w[1]:%.17g)" file p.txt title ""
fix xy all print 60 "$(-vol*c_p[4]:%.17g) $(c_sums[4]:%.17g) $(c_w[2]:%.17g)" file xy.txt title ""
)--" + run_line);
  for (const int count : {1, 2}) {
    ASSERT_TRUE(run_lammps(path_ / "scene", lammps_program, count)) << read("scene/log." + std::to_string(count));
    int pressed = 0;
    for (const char* name : {"scene/p.txt", "scene/xy.txt"}) {
      std::istringstream in(read(name));
      for (double whole = 0, atoms = 0, truth = 0; in >> whole >> atoms >> truth; pressed += truth != 0 ? 1 : 0) {
        EXPECT_NEAR(whole, -truth, 1e-11 * std::abs(truth) + 1e-13) << name;
        EXPECT_NEAR(atoms, -truth, 1e-11 * std::abs(truth) + 1e-13) << name;
      }
    }
    EXPECT_GE(pressed, 4);
  }
}

// LAMMPS prepares the pair style for each of these without running anything.
TEST_F(InLammps, WritesBalancesAndDeletesBetweenRuns) {
  Scene scene = without(crowd(), Conduction::name);
  // With dashpots a force jumps where a spring is at its limit, and so do the roundings of `balance`.
  scene.effects.friction = Friction{.coefficient = 0.4};
  scene.effects.rolling = Rolling{.coefficient = 0.1, .damping = 0};
  scene.effects.twisting = Twisting{.coefficient = 0.1, .damping = 0};
  run_for(scene, 5e-4, 100);
  export_to(path_ / "scene", scene, make_plan(scene));
  const std::string script = read("scene/in.lammps"), run_line = script.substr(script.rfind("run "));
  std::vector<std::string> dumps;
  std::vector<Trajectory> states;
  // `balance` rounds positions.
  for (const char* between : {"", "write_restart restart.%\nwrite_data data.written\nprint \"$(f_motion)\"\n",
                              "delete_atoms overlap 1e-9 all all compress no\n", "balance 1.1 shift xyz 5 1.1\n"}) {
    (void)file("scene/in.lammps", script + between + run_line);
    ASSERT_TRUE(run_lammps(path_ / "scene", lammps_program, 2)) << between << read("scene/log.2");
    dumps.push_back(read("scene/dump.2"));
    states.push_back(read_dump(path_ / "scene/dump.2"));
  }
  EXPECT_TRUE(dumps[1] == dumps[0]);
  EXPECT_TRUE(dumps[2] == dumps[0]);
  (void)file("scene/in.lammps", script + "delete_atoms overlap 1e-9 all all\n" + run_line);
  EXPECT_FALSE(run_lammps(path_ / "scene", lammps_program, 2));
  EXPECT_NE(read("scene/log.2").find("atoms have other IDs than in the run before"), std::string::npos);
  const auto apart = deviations(scene, states[0], states[3]);
  EXPECT_EQ(apart.rbegin()->first, 200);
  EXPECT_LT(apart.rbegin()->second.largest(), 1e-9);
}

// A run from a restart file, with other numbers of processes too, is the second run of a script to the bit.
TEST_F(InLammps, ARestartGoesOnToTheBit) {
  Scene scene = without(crowd(), Conduction::name);
  run_for(scene, 5e-4, 100);
  export_to(path_ / "scene", scene, make_plan(scene));
  const std::string script = read("scene/in.lammps"), run_line = script.substr(script.rfind("run "));
  const auto final_frame = [&](const std::string& text, int processes) {
    (void)file("scene/in.lammps", text);
    EXPECT_TRUE(run_lammps(path_ / "scene", lammps_program, processes))
        << read("scene/log." + std::to_string(processes));
    const std::string dump = read("scene/dump." + std::to_string(processes));
    return dump.substr(dump.rfind("ITEM: TIMESTEP"));
  };
  std::string again = script;
  const auto replace = [&again](const std::string& from, const std::string& to) {
    const auto at = again.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    again.replace(at, again.find('\n', at) - at, to);
  };
  replace("read_data", "");
  replace("fix shapes", "read_restart restart.lammps\nfix shapes all property/atom d_n1 d_n2 d_density ghost yes");
  for (const int processes : {2, 1}) {
    const std::string truth = final_frame(script + "write_restart restart.lammps\n" + run_line, processes);
    for (const int others : {1, 2, 4}) EXPECT_TRUE(final_frame(again, others) == truth) << processes << ' ' << others;
  }
  // From a file that was written while a run went on, too.
  const std::string ready = script.substr(0, script.rfind("run "));
  const std::string truth = final_frame(ready + "run 60\n" + "run 40\n", 2);
  (void)final_frame(ready + "restart 60 middle.*\n" + run_line, 2);
  replace("read_restart", "read_restart middle.60");
  EXPECT_TRUE(final_frame(again.substr(0, again.rfind("run ")) + "run 40\n", 2) == truth);
}

TEST_F(InLammps, AnIllegalAtomIsNamedWithItsField) {
  const auto refused = [&](const std::string& ghosts, const std::string& n1) {
    (void)file(
        "in.txt",
        "units lj\natom_style ellipsoid\nnewton off\ncomm_modify vel yes\nregion box block 0 1 0 1 0 1\n"
        "create_box 1 box\nfix shapes all property/atom d_n1 d_n2 d_density" +
            ghosts +
            "\ncreate_atoms 1 single 0.02 0.5 0.5\ncreate_atoms 1 single 0.98 0.5 0.5\nset group all shape 0.1 0.1 "
            "0.1\nset group all d_n1 " +
            n1 +
            "\nset group all d_n2 2\nset group all d_density 1\npair_style plumb/cn linear.stiffness 1\n"
            "pair_coeff * *\nfix motion all plumb/nve\nrun 0\n");
    return run("cd " + path_.string() + " && " + lammps_program + " -in in.txt -log none 2>&1 | grep ERROR").out;
  };
  const std::string field = "shape.superellipsoid.exponents[0]: must be finite and above 1";
  EXPECT_NE(refused(" ghost yes", "0.5").find(": atom 1: " + field + " ("), std::string::npos);
  const std::string of_ghost = refused("", "2");
  EXPECT_NE(of_ghost.find(field + "; fix property/atom needs `ghost yes`"), std::string::npos) << of_ghost;
  EXPECT_EQ(refused(" ghost yes", "2"), "");
}

TEST_F(InLammps, RefusesInOneLineWhatItCannotDo) {
  const auto refused = [&](const std::string& script) {
    (void)file("in.txt",
               "units lj\natom_style ellipsoid\nnewton off\ncomm_modify vel yes\nregion box block 0 1 0 1 0 1\n"
               "create_box 1 box\n" +
                   script);
    return run("cd " + path_.string() + " && " + lammps_program + " -in in.txt -log none 2>&1 | grep ERROR").out;
  };
  EXPECT_NE(refused("pair_style plumb/cn conduction.conductivity 1\n").find("conduction: is not supported"),
            std::string::npos);
  EXPECT_NE(refused("pair_style plumb/cn linear.stiffness x\n").find("linear.stiffness: 'x' is no number"),
            std::string::npos);
  EXPECT_NE(refused("fix floor all plumb/wall 0 0 0 0 0\n").find("plumb/wall: normal: is missing"), std::string::npos);
  EXPECT_NE(refused("pair_style plumb/cn linear.stiffness 1\npair_coeff * *\ncreate_atoms 1 single 0 0 0\nrun 0\n")
                .find("needs one fix plumb/nve"),
            std::string::npos);
  const std::string ready =
      "fix shapes all property/atom d_n1 d_n2 d_density ghost yes\ncreate_atoms 1 single 0.5 0.5 0.5\n"
      "set group all shape 0.1 0.1 0.1\nset group all d_n1 2\nset group all d_n2 2\nset group all d_density 1\n"
      "pair_style plumb/cn linear.stiffness 1\npair_coeff * *\nfix motion all plumb/nve\n";
  EXPECT_NE(refused(ready + "dump d all custom 1 dump.rerun id x y z\nrun 1\nundump d\nrerun dump.rerun dump x y z\n")
                .find("cannot rerun: a dump does not bring back orientations"),
            std::string::npos);
  EXPECT_NE(refused(ready + "pair_coeff 1 1 rigid yes\nfix f all plumb/wall 0 0 0 0 0 1\nrun 0\n")
                .find("type 1 and type 1 are rigid and can meet"),
            std::string::npos);
  EXPECT_NE(refused(ready + "pair_coeff 1 1 drag.coefficient 1\n").find("pair_coeff 1 1: drag: holds for all types"),
            std::string::npos);
  EXPECT_NE(refused(ready + "fix f all plumb/wall 0 0 0 0 0 1 type 2\n").find("type: must be one of the 1 types"),
            std::string::npos);
  EXPECT_NE(refused(ready + "minimize 0 0 1 1\n").find("cannot minimize"), std::string::npos);
  EXPECT_NE(
      refused("region r block 0.1 0.9 0.1 0.9 0.1 0.9\n" + ready + "fix w all wall/region r harmonic 1 0 0.2\nrun 1\n")
          .find("fix w: wall/region takes atoms for points: use fix plumb/wall"),
      std::string::npos);
}

}  // namespace
}  // namespace plumb::scene
