// plumb export-lammps: a scene as an input script and a data file for plumb-lammps.
#include <filesystem>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/lammps/lammps_files.hpp"
#include "corpus/scene/scene_file.hpp"

namespace plumb::scene {
namespace {

int export_command(const std::string& path, const std::filesystem::path& folder) {
  const SceneFile file = read_scene(path);
  const std::string name = path == "-" ? "standard input" : path;
  const Plan plan = plan_scene(file.scene, {}, name);
  try {
    const LammpsFiles files = lammps_files(file.scene, plan);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail_with(folder.string(), error.value());
    write_file(folder / "data.lammps", files.data);
    write_file(folder / "in.lammps", files.script);
  } catch (const SceneError& error) {
    throw InputFailure(name, 0, error.field, error.what());
  }
  return exit_done;
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  std::string scene, out;
  plumb::CommandLine app("Write a scene as LAMMPS input for plumb-lammps.", "plumb export-lammps");
  app.add_option("SCENE", scene, "scene file, or - for standard input")->required();
  app.add_option("-o,--out", out, "folder for in.lammps and data.lammps")->required();
  return plumb::run_command(app, argc, argv, [&] { return plumb::scene::export_command(scene, out); });
}
