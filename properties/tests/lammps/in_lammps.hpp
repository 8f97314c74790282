// LAMMPS as the tests run it: a scene by plumb and by it, or a script.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/tests/corpus/programs.hpp"
#include "reports/lammps/trajectory.hpp"

namespace plumb::scene {

#ifdef PLUMB_LAMMPS_PROGRAM
inline const std::string lammps_program = PLUMB_LAMMPS_PROGRAM;
#else
inline const std::string lammps_program;
#endif

class InLammps : public Commands {
 protected:
  void SetUp() override {
    if (lammps_program.empty()) GTEST_SKIP() << "plumb-lammps is not built: liblammps-dev or MPI is missing";
    Commands::SetUp();
  }

  /// The largest deviation at any frame. The dumps of all numbers of processes are the same text.
  [[nodiscard]] double largest_deviation(const Scene& scene, const std::vector<int>& ranks) const {
    const Plan plan = make_plan(scene);
    const fs::path folder = path_ / "scene";
    export_to(folder, scene, plan);
    const Trajectory reference = trajectory_of(scene, plan);
    double largest = 0;
    for (const int count : ranks) {
      EXPECT_TRUE(run_lammps(folder, lammps_program, count)) << read("scene/log." + std::to_string(count));
      EXPECT_EQ(read("scene/dump." + std::to_string(count)), read("scene/dump." + std::to_string(ranks.front())));
      const auto apart = deviations(scene, reference, read_dump(folder / ("dump." + std::to_string(count))));
      EXPECT_EQ(apart.size(), reference.size()) << count << " processes";
      for (const auto& [step, deviation] : apart) largest = std::max(largest, deviation.largest());
    }
    return largest;
  }

  /// What a script prints, errors too, and how it ends.
  [[nodiscard]] Ran script(const std::string& text, int processes = 1) const {
    (void)file("in.txt", text);
    const std::string program =
        processes == 1 ? "" : lammps_environment + "mpirun -n " + std::to_string(processes) + " ";
    return run("cd " + path_.string() + " && " + program + lammps_program + " -in in.txt -log none </dev/null 2>&1");
  }

  /// The lines of what was printed that say what went wrong.
  [[nodiscard]] static std::string errors(const std::string& printed) {
    std::string out;
    std::istringstream in(printed);
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("ERROR") || line.starts_with("Last command")) out += line + "\n";
    return out;
  }

  /// The numbers of each line of thermo that a run printed.
  [[nodiscard]] static std::vector<std::vector<double>> thermo(const std::string& printed) {
    std::vector<std::vector<double>> out;
    std::istringstream in(printed);
    bool is_in_table = false;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("Loop time")) is_in_table = false;
      if (is_in_table) {
        std::istringstream words(line);
        out.emplace_back();
        for (double x = 0; words >> x;) out.back().push_back(x);
      }
      if (line.starts_with("Step")) is_in_table = true;
    }
    return out;
  }
};

}  // namespace plumb::scene
