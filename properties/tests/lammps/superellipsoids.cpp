// pair_style plumb/superellipsoid: scripts for LAMMPS's own pair_style granular/superellipsoid, with that one line changed.
#include <fmt/format.h>

#include "properties/tests/lammps/in_lammps.hpp"
#include "properties/tests/lammps/words.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/lammps/superellipsoid/coefficients.hpp"
#include "solver/lammps/superellipsoid/words.hpp"

namespace plumb::scene {
namespace {

SuperellipsoidCoefficients coefficients(const std::string& text) {
  return parse_superellipsoid_coefficients(words_of(text));
}

TEST(SuperellipsoidCoefficients, AreEffectsOfAScene) {
  const Effects hooke =
      effects_of(coefficients("hooke 1000 50 tangential linear_history 285 0.5 0.4 damping mass_velocity"));
  EXPECT_EQ(hooke.linear.value_or(Linear{}).stiffness, 1000);
  EXPECT_EQ(hooke.damping.value_or(Damping{}).mass_velocity, 50);
  EXPECT_EQ(hooke.damping.value_or(Damping{}).viscoelastic, 0);
  EXPECT_EQ(hooke.damping.value_or(Damping{}).pull, 1);
  EXPECT_EQ(hooke.friction.value_or(Friction{}).stiffness, 285);
  EXPECT_EQ(hooke.friction.value_or(Friction{}).normal_share, 0.5);
  EXPECT_EQ(hooke.friction.value_or(Friction{}).coefficient, 0.4);
  const Effects hertz =
      effects_of(coefficients("hertz 1000 50 limit_damping cutoff 2 tangential linear_history 285 0 0"));
  EXPECT_FALSE(hertz.linear);
  EXPECT_NEAR(4.0 / 3 * hertz.hertz.value_or(Hertz{}).contact_modulus(), 1000, 1e-12);
  EXPECT_EQ(hertz.damping.value_or(Damping{}).viscoelastic, 50);
  EXPECT_EQ(hertz.damping.value_or(Damping{}).pull, 0);
  EXPECT_EQ(hertz.friction.value_or(Friction{}).coefficient, 0);
}

TEST(SuperellipsoidCoefficients, AreRefusedWithNameAndReason) {
  const auto refusal = [](const std::string& text) { return refusal_by(parse_superellipsoid_coefficients, text); };
  EXPECT_EQ(refusal("hooke 1 0"), "none");
  EXPECT_EQ(refusal("jkr 1 0"), "jkr: must be hooke or hertz");
  EXPECT_EQ(refusal("hooke 1"), "hooke: needs a word after it");
  EXPECT_EQ(refusal("hooke 1 x"), "hooke: 'x' is no number");
  EXPECT_EQ(refusal("hooke 1 -1"), "hooke: must be a number, 0 or more");
  EXPECT_EQ(refusal("hooke 1 0 tangential classic 1 0 0.5"),
            "tangential: 'classic' is not in LAMMPS's manual: use linear_history");
  EXPECT_EQ(refusal("hooke 1 0 tangential linear_history 0 1 0.5"),
            "linear_history: friction needs a stiffness above 0");
  EXPECT_EQ(refusal("hooke 1 0 damping tsuji"), "damping: must be mass_velocity or viscoelastic");
  EXPECT_EQ(refusal("hooke 1 0 rolling sds 1 1 1"), "rolling: must be tangential, damping, limit_damping or cutoff");
}

TEST(SuperellipsoidCoefficients, OfTwoTypesAreGeometricMeans) {
  const auto first = coefficients("hooke 400 4 tangential linear_history 100 1 0.2"),
             second = coefficients("hooke 100 9 tangential linear_history 400 1 0.8");
  const auto both = mixed(first, second);
  EXPECT_NEAR(both.stiffness, 200, 1e-12);
  EXPECT_NEAR(both.damping, 6, 1e-12);
  EXPECT_NEAR(both.tangential_stiffness, 200, 1e-12);
  EXPECT_NEAR(both.friction, 0.4, 1e-15);
  EXPECT_EQ(mixed(first, first), first);
  EXPECT_THROW((void)mixed(first, coefficients("hertz 1 0")), SceneError);
}

TEST(SuperellipsoidWords, AreThoseOfThisLammps) {
  const auto after = [](const std::string& line, bool has_superellipsoids = true) {
    const auto words = words_of(line);
    const auto lines = lammps::in_older_words(words.front(), std::span(words).subspan(1), has_superellipsoids);
    return fmt::format("{}", fmt::join(lines, " | "));
  };
  EXPECT_EQ(after("atom_style ellipsoid superellipsoid", false),
            "atom_style ellipsoid | fix plumb_superellipsoids all property/atom d_n1 d_n2 d_density ghost yes | "
            "neigh_modify every 1 delay 0 check yes");
  EXPECT_EQ(after("set type 2 shape 2 1 1 block 4 v_n"),
            "set type 2 shape 2 1 1 d_density 0 d_n1 4 d_n2 v_n d_density 0");
  EXPECT_EQ(after("set group mass mass 2"), "set group mass mass 2 d_density 0");
  EXPECT_EQ(after("set group all density 2600"), "set group all density 2600 d_density 2600");
  EXPECT_EQ(after("fix 3 all nve/asphere"), "fix 3 all plumb/nve");
  EXPECT_EQ(after("compute b all property/atom block1 block2"), "compute b all property/atom d_n1 d_n2");
  EXPECT_EQ(after("compute e all erotate/asphere"), "compute e all plumb/erotate");
  EXPECT_EQ(after("compute block1 block2 property/atom block1"), "compute block1 block2 property/atom d_n1");
  EXPECT_EQ(after("read_restart r.rst"), "unfix plumb_superellipsoids | read_restart r.rst");
  for (const char* same : {"set group all x 1", "fix 1 all nve", "run 100", "atom_style ellipsoid"})
    EXPECT_EQ(after(same), "") << same;
  for (const char* line : {"set group all block 4 4", "fix 3 all nve/asphere", "compute e all erotate/asphere"})
    EXPECT_EQ(after(line, false), "") << line;
}

class InLammpsSuperellipsoids : public InLammps {
 protected:
  /// Two bodies of mass 1 above each other, of these diameters, the lower frozen, and what stands for forces.
  [[nodiscard]] static std::string above_each_other(const std::string& shape, const std::string& forces) {
    return "units si\natom_style ellipsoid superellipsoid\nboundary p p p\ncomm_modify vel yes\nnewton off\n"
           "region box block 0 10 0 10 0 10\ncreate_box 1 box\ncreate_atoms 1 single 5 5 4.5\n"
           "create_atoms 1 single 5 5 6\ngroup lower id 1\ngroup upper id 2\nset group all mass 1.0\n" +
           shape + forces + "fix hold lower freeze\nfix fall upper gravity 9.81 vector 0 0 -1\n" +
           "fix motion all nve/asphere\nthermo_style custom step ke pe\nthermo_modify norm no format float %.10g\n"
           "thermo 10\ntimestep 0.001\n";
  }
  [[nodiscard]] std::vector<std::vector<double>> table_of(const std::string& text, int processes = 1) const {
    const Ran ran = script(text, processes);
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    return thermo(ran.out);
  }
};

struct LoggedEnergy {
  int step;
  double kinetic;  ///< to the digits that LAMMPS prints
};

// The setting of LAMMPS's examples/ASPHERE/superellipsoid_gran/in.ellipsoid_gran, and what its log.23Aug2026 says (LAMMPS 4Jul2026): here
// the midway point's normal is the common normal.
TEST_F(InLammpsSuperellipsoids, TwoEllipsoidsBounceAsLammpsSays) {
  const auto table = table_of(
      above_each_other("set group all shape 2 1 1 block 2 2\n",
                       "pair_style plumb/superellipsoid\n"
                       "pair_coeff * * hooke 1000 0 tangential linear_history 285 0 0.5 damping mass_velocity\n") +
      "run 3000\n");
  ASSERT_EQ(table.size(), 301U);
  for (const LoggedEnergy logged : {LoggedEnergy{10, 0.004811805},
                                    {320, 4.9237228},
                                    {340, 3.5696362},
                                    {370, 0.021149699},
                                    {410, 4.3004428},
                                    {740, 0.00081807229},
                                    {1080, 4.1035018},
                                    {1110, 0.18665664},
                                    {1490, 0.00015576483},
                                    {2980, 0.00071517926},
                                    {3000, 0.027382699}}) {
    const auto& row = table.at(static_cast<std::size_t>(logged.step / 10));
    EXPECT_EQ(row.at(0), logged.step);
    EXPECT_NEAR(row.at(1), logged.kinetic, 1e-7 * logged.kinetic + 1e-9) << logged.step;
  }
}

TEST_F(InLammpsSuperellipsoids, ARunIsTheSameOnTwoProcesses) {
  const std::string text =
      above_each_other("set group all shape 2 1 1 block 4 3\nset group all quat/random 7\n",
                       "pair_style plumb/superellipsoid 2.5 no_bounding_box curvature_gaussian\n"
                       "pair_coeff * * hertz 10000 20 tangential linear_history 2000 0.5 0.5\n"
                       "compute turning upper erotate/asphere\ncompute exponents all property/atom block1 block2\n"
                       "dump all all custom 100 dump.txt id x y z c_exponents[1] c_exponents[2]\n"
                       "dump_modify all sort id\n") +
      "thermo_style custom step ke c_turning\nrun 600\n";
  const auto one = table_of(text);
  const std::string dump = read("dump.txt");
  EXPECT_EQ(table_of("processors 1 1 2\n" + text, 2), one);
  EXPECT_EQ(read("dump.txt"), dump);
  EXPECT_NE(dump.find(" 4 3\n"), std::string::npos) << dump;
  EXPECT_GT(one.back().at(2), 0.01);
}

// The mass that was set stays; of a density, the mass is that of the superellipsoid.
TEST_F(InLammpsSuperellipsoids, MassesAreThoseOfTheScript) {
  const std::string forces = "pair_style plumb/superellipsoid\npair_coeff * * hooke 1000 0\n"
                             "variable mass equal mass(upper)\n";
  const auto mass = [&](const std::string& set) {
    return table_of(above_each_other("set group all shape 2 1 1 block 4 4\n" + set, forces) +
                    "thermo_style custom step v_mass\nrun 1\n")
        .back()
        .at(1);
  };
  const double volume = mass_properties({{1, 0.5, 0.5}, 4, 4}).volume;
  EXPECT_EQ(mass(""), 1);
  EXPECT_EQ(mass("set group all mass 3\n"), 3);
  EXPECT_NEAR(mass("set group all density 2\n"), 2 * volume, 1e-5 * volume);
  EXPECT_EQ(mass("set group all density 2\nset group all mass 3\n"), 3);
  EXPECT_EQ(mass("set group all mass 3\nset group all shape 1 1 1 block 2 2\n"), 3);
  EXPECT_NEAR(mass("set group all density 2\nset group all shape 1 1 1 block 2 2\n"), 2 * volume, 1e-5 * volume);
  const auto between_runs =
      table_of(above_each_other("set group all shape 1 1 1\n", forces) +
               "thermo_style custom step v_mass\nrun 1\nset group all shape 2 1 1 block 6 6\nrun 1\n");
  EXPECT_EQ(between_runs.back().at(1), 1);
}

// With atom_style in the script that reads it, or without: LAMMPS needs none there.
TEST_F(InLammpsSuperellipsoids, ARestartGoesOnToTheBit) {
  const std::string pair = "pair_style plumb/superellipsoid\n"
                           "pair_coeff * * hertz 10000 20 tangential linear_history 2000 0.5 0.5\n";
  const std::string computes = "compute exponents all property/atom block1 block2\n"
                               "dump all all custom 100 dump.txt id x y z vx vy vz c_exponents[1] c_exponents[2]\n"
                               "dump_modify all sort id format float %.17g\n";
  const std::string first =
      above_each_other("set group all shape 2 1 1 block 4 3\nset group all quat/random 7\n", pair);
  (void)table_of(first + computes + "run 300\nrun 300\n");
  const std::string dump = read("dump.txt"), last = dump.substr(dump.rfind("ITEM: TIMESTEP"));
  ASSERT_NE(last.find(" 4 3\n"), std::string::npos) << last;
  (void)table_of(first + "run 300\nwrite_restart r.rst\n");
  for (const char* const style : {"atom_style ellipsoid superellipsoid\n", ""}) {
    (void)table_of(std::string("units si\n") + style + "newton off\ncomm_modify vel yes\nread_restart r.rst\n" + pair +
                   "fix hold lower freeze\nfix fall upper gravity 9.81 vector 0 0 -1\nfix motion all nve/asphere\n" +
                   "timestep 0.001\n" + computes + "run 300\n");
    const std::string again = read("dump.txt");
    EXPECT_EQ(again.substr(again.rfind("ITEM: TIMESTEP")), last) << style;
  }
}

// LAMMPS's own integrator may stand anywhere.
TEST_F(InLammpsSuperellipsoids, FixesStandInAnyOrder) {
  const std::string before = "units si\natom_style ellipsoid superellipsoid\nnewton off\ncomm_modify vel yes\n"
                             "region box block 0 10 0 10 0 10\ncreate_box 1 box\ncreate_atoms 1 single 5 5 4.5\n"
                             "create_atoms 1 single 5 5.1 5.4\ngroup lower id 1\ngroup upper id 2\n"
                             "set group all mass 1 shape 1 1 1 block 3 3\npair_style plumb/superellipsoid\n"
                             "pair_coeff * * hooke 1000 0 tangential linear_history 300 0 0.4\n";
  const std::string motion = "fix motion all nve/asphere\n",
                    forces = "fix fall upper gravity 9.81 vector 0 0 -1\nfix hold lower setforce 0 0 0\n";
  const std::string after =
      "thermo_style custom step ke pe\nthermo_modify format float %.17g\ntimestep 1e-3\nrun 200\n";
  const auto table = table_of(before + motion + forces + after);
  EXPECT_GT(table.back().at(1), 0.01);
  EXPECT_EQ(table_of(before + "fix fall upper gravity 9.81 vector 0 0 -1\n" + motion +
                     "fix hold lower setforce 0 0 0\n" + after),
            table);
  const auto pushed =
      table_of(before + motion + "fix hold all setforce 0 0 0\nfix push upper addforce 0 0 -3\n" + after);
  EXPECT_NEAR(pushed.back().at(1), 0.6 * 0.6 / 2, 0.01) << "what is added after forces were replaced stays";
}

// A pair's coefficients are the same in either order, and its law its own.
TEST_F(InLammpsSuperellipsoids, EachPairOfTypesHasItsLaw) {
  const auto energy = [&](const std::string& coefficients) {
    return table_of("units si\natom_style ellipsoid superellipsoid\nnewton off\ncomm_modify vel yes\n"
                    "region box block 0 10 0 10 0 10\ncreate_box 2 box\ncreate_atoms 1 single 5 5 5\n"
                    "create_atoms 2 single 5 5 5.98\ncreate_atoms 1 single 2 2 2\ncreate_atoms 1 single 2 2 2.98\n"
                    "set group all shape 1 1 1\npair_style plumb/superellipsoid\n" +
                    coefficients +
                    "fix motion all nve/asphere\nvariable f atom fz\ncompute least all reduce min v_f\n"
                    "thermo_style custom step pe c_least\nthermo_modify norm no format float %.10g\nrun 0\n")
        .back();
  };
  const double overlap = 0.02, soft = 1000 * overlap * overlap / 2;
  EXPECT_NEAR(energy("pair_coeff 1 1 hooke 1000 0\npair_coeff 2 2 hooke 1000 0\npair_coeff 2 1 hooke 5000 0\n").at(1),
              6 * soft, 1e-9);
  const auto mixed = energy("pair_coeff 1 1 hooke 1000 0\npair_coeff 2 2 hertz 3000 0\npair_coeff 1 2 hooke 5000 0\n");
  EXPECT_NEAR(mixed.at(1), 6 * soft, 1e-9);
  EXPECT_NEAR(mixed.at(2), -5000 * overlap, 1e-8);
}

/// Two balls of radius 1/2 that meet off centre, and at what velocities they part, by LAMMPS's pair_style granular or this one.
std::string two_balls(bool is_of_plumb, const std::string& coefficients) {
  const std::string style = is_of_plumb ? "atom_style ellipsoid superellipsoid\n" : "atom_style sphere\n";
  const std::string motion = is_of_plumb ? "nve/asphere" : "nve/sphere";
  return "units si\n" + style +
         "newton off\natom_modify map array\ncomm_modify vel yes\nregion box block 0 10 0 10 0 10\n"
         "create_box 2 box\n"
         "create_atoms 1 single 4.49 5 5\ncreate_atoms 2 single 5.5 5.3 5.1\n" +
         (is_of_plumb ? "set group all shape 1 1 1\n" : "set group all diameter 1\n") +
         "set type 1 mass 1\nset type 2 mass 2\nvelocity all set 0 0 0\ngroup first type 1\n"
         "velocity first set 1 0.2 0.1\n" +
         "pair_style " + (is_of_plumb ? "plumb/superellipsoid\n" : "granular\n") + "pair_coeff * * " + coefficients +
         "\nfix motion all " + motion +
         "\nneigh_modify every 1 delay 0 check yes\nvariable x equal vx[1]\nvariable y equal vy[1]\n"
         "variable z equal vz[2]\nthermo_style custom step v_x v_y v_z\nthermo_modify format float %.10g\n" +
         "timestep 2.5e-5\nthermo 16000\nrun 16000\n";
}

struct Balls {
  const char* coefficients;
  double within;  ///< of velocities about 1
};

// Within a share of the overlap, by which levers differ, and of the step: a dashpot's velocity is that of the moment here, and of half a
// step before there. Friction's limit has the dashpot's force in it there: of balls that stick at their end it is not the same.
TEST_F(InLammpsSuperellipsoids, BallsPartAsByPairStyleGranular) {
  for (const auto& [coefficients, within] :
       {Balls{"hooke 1e6 0 tangential linear_history 3e5 0 10", 5e-5},
        {"hooke 1e6 0 tangential linear_history 3e5 0 0.1", 5e-5},
        {"hooke 1e6 1000 tangential linear_history 3e5 0.5 10 damping viscoelastic", 5e-5},
        {"hooke 1e6 300 tangential linear_history 3e5 1 10 damping mass_velocity", 1e-3},
        {"hooke 1e6 300 tangential linear_history 3e5 0 0.1 damping mass_velocity limit_damping", 1e-3},
        {"hertz 1e7 3000 tangential linear_history 1e6 0 0", 5e-6},
        {"hertz 1e7 3000 tangential linear_history 1e6 1 0.05 damping viscoelastic", 2e-4},
        {"hertz 1e7 100 tangential linear_history 1e6 0 0 damping mass_velocity", 5e-4}}) {
    const auto here = table_of(two_balls(true, coefficients)), there = table_of(two_balls(false, coefficients));
    for (std::size_t k = 1; k <= 3; ++k)
      EXPECT_NEAR(here.back().at(k), there.back().at(k), within) << coefficients << ' ' << k;
    EXPECT_LT(here.back().at(1), 0) << "they have not met";
  }
}

TEST_F(InLammpsSuperellipsoids, RefusesInOneLineWhatItCannotDo) {
  const auto refused = [&](const std::string& forces) {
    const Ran ran = script(above_each_other("set group all shape 2 1 1\n", forces) + "run 1\n");
    EXPECT_NE(ran.code, 0);
    return errors(ran.out);
  };
  EXPECT_NE(refused("pair_style plumb/superellipsoid smooth\n").find("cutoff: 'smooth' is no number"),
            std::string::npos);
  EXPECT_NE(refused("pair_style plumb/superellipsoid\npair_coeff * * hooke 1 0 tangential classic 1 0 0.5\n")
                .find("pair_coeff * *: tangential: 'classic' is not in LAMMPS's manual"),
            std::string::npos);
  EXPECT_NE(refused("pair_style granular/superellipsoid\n").find("is not in this LAMMPS: use plumb/superellipsoid"),
            std::string::npos);
  EXPECT_NE(refused("pair_style plumb/superellipsoid\npair_coeff * * hooke 1 0\nset group lower angmom 0 0 1\n")
                .find("fix freeze holds bodies that turn: set their angmom to 0"),
            std::string::npos);
}

}  // namespace
}  // namespace plumb::scene
