// The input that is written for LAMMPS, and the arguments of pair_style plumb/cn; no LAMMPS is needed.
#include <gtest/gtest.h>

#include "corpus/lammps/lammps_files.hpp"
#include "corpus/scene/scene_file.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/lammps/words.hpp"
#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/crowded_box.hpp"
#include "solver/lammps/pair_arguments.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

std::string refusal(const std::string& text) {
  return refusal_by(parse_pair_arguments, text);
}

TEST(PairArguments, ReadBackAsTheyWereWritten) {
  PairArguments arguments{crowd().effects, 1e-5};
  arguments.effects.gravity.reset();
  arguments.effects.conduction.reset();
  arguments.effects.moving_walls.reset();
  const std::string text = pair_arguments_text(arguments);
  EXPECT_EQ(pair_arguments_text(parse_pair_arguments(words_of(text))), text);
  EXPECT_NE(text.find("friction.coefficient 0.4 friction.stiffness_ratio 0.3 friction.damping 0.2"), std::string::npos);
  EXPECT_NE(text.find("drag.fluid_velocity 0.1 0 0"), std::string::npos);
}

TEST(PairArguments, AreRefusedWithNameAndReason) {
  EXPECT_EQ(refusal("linear.stiffness 1e5 damping.restitution 0.5"), "none");
  EXPECT_EQ(refusal("linear.stiffness"), "linear.stiffness: needs a number after it");
  EXPECT_EQ(refusal("linear.stiffness 1x"), "linear.stiffness: '1x' is no number");
  EXPECT_EQ(refusal("linear.stiffness -1"), "linear.stiffness: must be a number, 0 or more");
  EXPECT_EQ(refusal("linear.stifness 1"), "linear.stifness: is no field of an effect");
  EXPECT_EQ(refusal("stiffness 1"), "stiffness: is no field of an effect");
  EXPECT_EQ(refusal("linear.stiffness 1 linear.stiffness 2"), "linear.stiffness: stands there twice");
  EXPECT_EQ(refusal("linear.stiffness 1 friction.damping 0.1"),
            "friction.coefficient: is required with the other fields of its effect");
  EXPECT_EQ(refusal("gravity.acceleration 0 0 -1"), "gravity: is fix gravity's");
  EXPECT_EQ(refusal("accuracy 1"), "accuracy: must be a number between 0 and 1");
}

TEST(MaterialArguments, ReadBackAsTheyWereWritten) {
  MaterialArguments arguments;
  arguments.effects.hertz = Hertz{.youngs_modulus = 7e6, .poissons_ratio = 0.2};
  arguments.effects.friction = Friction{.coefficient = 0.4};
  const std::string text = material_arguments_text(arguments);
  EXPECT_EQ(text.find(" hertz.youngs_modulus 7e+06 hertz.poissons_ratio 0.2 friction.coefficient 0.4"), 0U) << text;
  EXPECT_EQ(material_arguments_text(parse_material_arguments(words_of(text))), text);
  EXPECT_EQ(material_arguments_text(parse_material_arguments(words_of("rigid yes"))), " rigid yes");
}

TEST(MaterialArguments, AreRefusedWithNameAndReason) {
  const auto refused = [](const std::string& text) { return refusal_by(parse_material_arguments, text); };
  EXPECT_EQ(refused("rigid no friction.coefficient 0.5"), "none");
  EXPECT_EQ(refused("rigid"), "rigid: must be yes or no");
  EXPECT_EQ(refused("drag.coefficient 1"), "drag: holds for all types: give it to pair_style");
  EXPECT_EQ(refused("volume.stiffness 1"), "volume: holds for all types: give it to pair_style");
  EXPECT_EQ(refused("gravity.acceleration 0 0 -1"), "gravity: is fix gravity's");
  EXPECT_EQ(refused("friction.coefficient 1 friction.coefficient 1"), "friction.coefficient: stands there twice");
  EXPECT_EQ(refused("accuracy 0.1"), "accuracy: is no field of an effect");
}

TEST(LammpsFiles, NameEveryBodyWallAndEffect) {
  const Scene scene = without(crowd(), Conduction::name);
  const LammpsFiles files = lammps_files(scene, make_plan(scene));
  for (const char* line :
       {"pair_style plumb/cn accuracy 0.01 linear.stiffness 20000 damping.restitution 0.7",
        "fix wall0 all plumb/wall 0 0 0 0 0 1 velocity 0 0 0 amplitude 0 0 0.01 frequency 3\n",
        "fix wall2 all plumb/wall 2.65 0 0 -1 0.1 0\n", "fix gravity moves gravity 10 vector 0 0 -10\n"})
    EXPECT_NE(files.script.find(line), std::string::npos) << line;
  EXPECT_NE(files.data.find("\n12 atoms\n12 ellipsoids\n"), std::string::npos);
}

// Text of a scene's file that LAMMPS would run or count by.
TEST(LammpsFiles, ANameIsNoCommand) {
  Scene scene = without(crowd(), Conduction::name);
  const LammpsFiles plain = lammps_files(scene, make_plan(scene));
  scene.name = "a\nshell touch made\r\n\"\"\"b\"\"\" " + std::string(300, 'c') + "\n7 atoms\n&";
  const LammpsFiles named = lammps_files(scene, make_plan(scene));
  const std::string first = named.script.substr(0, named.script.find('\n') + 1);
  EXPECT_TRUE(first.starts_with("# plumb: scene a shell touch made     b    " + std::string(300, 'c') + " 7 atoms  "))
      << first;
  EXPECT_EQ(named.script.substr(first.size()), plain.script.substr(plain.script.find('\n') + 1));
  EXPECT_EQ(named.data, plain.data);
}

// LAMMPS divides each quaternion by its norm as it reads it.
TEST(LammpsFiles, OrientationsAreReadAsTheyAreToTheBit) {
  const Scene scene = without(crowd(), Conduction::name);
  const Plan plan = make_plan(scene);
  const std::string data = lammps_files(scene, plan).data;
  std::istringstream in(data.substr(data.find("Ellipsoids\n\n") + 12));
  const Simulation start(scene, plan);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    std::string line;
    ASSERT_TRUE(std::getline(in, line));
    const auto words = words_of(line);
    ASSERT_EQ(words.size(), 8U);
    std::array<double, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) q[k] = std::stod(words[4 + k]);
    const double factor = 1 / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(q[k] * factor, start.world().state.orientation->entry(i)[k]) << i;
  }
}

class ExportLammps : public Commands {};

TEST_F(ExportLammps, RefusesWithFileFieldAndReason) {
  Scene scene = crowd();
  (void)file("heat.json", format_scene({scene, {}, {}}));
  expect_refusal("export-lammps heat.json -o out",
                 "heat.json: effects.conduction: a part of a scene keeps no temperatures: run the "
                 "scene by itself");
  scene = without_elastic_forces(scene);
  (void)file("soft.json", format_scene({scene, {}, {}}));
  expect_refusal("export-lammps soft.json -o out",
                 "soft.json: effects: an elastic law is required: linear, hertz, volume or foundation");
  scene = without(crowd(), Conduction::name);
  scene.materials = {{.name = "wax", .density = {}, .is_rigid = false, .effects = {}}};
  scene.material_pairs = {{{0, 0}, {}}};
  scene.material_pairs[0].effects.friction = Friction{0.1};
  (void)file("itself.json", format_scene({scene, {}, {}}));
  expect_refusal("export-lammps itself.json -o out",
                 "itself.json: materials.pairs[0]: is of a material with itself, which pair_coeff cannot say");
  scene = without(made::crowded_box(), Conduction::name);
  made::periodic_box(scene).rate = {-1, 0, 0};
  (void)file("shrinks.json", format_scene({scene, {}, {}}));
  expect_refusal(
      "export-lammps shrinks.json -o out",
      "shrinks.json: effects.periodic_box.rate: is not exported: LAMMPS's fix deform changes a box by another law");
  scene = without(crowd(), Conduction::name);
  (void)file("good.json", format_scene({scene, {}, {}}));
  EXPECT_EQ(plumb("export-lammps good.json -o out").code, 0);
  EXPECT_EQ(read("out/in.lammps").substr(0, 20), "# plumb: scene crowd");
}

}  // namespace
}  // namespace plumb::scene
