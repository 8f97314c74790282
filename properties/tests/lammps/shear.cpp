// Boxes that lean and change: fix deform, with what it does to images, velocities and the processes' shares.
#include "properties/tests/lammps/crate.hpp"
#include "properties/tests/lammps/in_lammps.hpp"

namespace plumb::scene {
namespace {

class InShear : public InLammps {
 protected:
  /// The dump is the same text on so many processes, and thermo the same to the rounding of its sums.
  void expect_same(const std::string& text, const std::vector<std::pair<int, std::string>>& grids) const {
    std::string dump;
    std::vector<std::vector<double>> table;
    for (const auto& [processes, grid] : grids) {
      const Ran ran = script("processors " + grid + "\n" + text, processes);
      ASSERT_EQ(ran.code, 0) << errors(ran.out);
      if (dump.empty()) {
        dump = read("dump.txt");
        table = thermo(ran.out);
      }
      EXPECT_TRUE(read("dump.txt") == dump) << grid;
      expect_near(thermo(ran.out), table);
    }
    EXPECT_GT(table.size(), 3U);
  }

  /// Relative to the largest number of its column.
  static void expect_near(const std::vector<std::vector<double>>& one, const std::vector<std::vector<double>>& other,
                          double tolerance = 1e-12) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < other.front().size(); ++k) {
      double largest = 0;
      for (const auto& row : other) largest = std::max(largest, std::abs(row.at(k)));
      for (std::size_t row = 0; row < one.size(); ++row)
        EXPECT_NEAR(one[row].at(k), other[row][k], tolerance * largest) << row << ' ' << k;
    }
  }
};

// Bodies go from one side to the other while they touch, the box flips, and whole columns of them change their process.
TEST_F(InShear, TheStressIsThatOfAnyNumberOfProcesses) {
  (void)file("data.txt", data_text({.side = 6, .spacing = 0.85, .shear_rate = 2}));
  const std::string text = script_text({.before_motion = "fix shear all deform 1 xy erate 2 remap v\n"}) + "run 350\n";
  expect_same(text, {{1, "* * *"}, {2, "2 1 1"}, {4, "2 2 1"}});
}

// A box that leans by more than half is the same as one that has flipped.
TEST_F(InShear, AFlipChangesNothing) {
  (void)file("data.txt", data_text({.side = 4, .spacing = 0.85, .shear_rate = 2}));
  const auto table = [&](const char* flip) {
    const Ran ran = script(
        script_text({.before_motion = fmt::format("fix shear all deform 1 xy erate 2 remap v flip {}\n", flip)}) +
        "run 350\n");
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    return thermo(ran.out);
  };
  expect_near(table("yes"), table("no"), 1e-10);
}

TEST_F(InShear, ACompressionIsThatOfAnyNumberOfProcesses) {
  (void)file("data.txt", data_text({.side = 4, .spacing = 1.1}));
  for (const char* deform : {"x scale 0.8 y scale 0.8 z scale 0.8", "x erate -0.5 y volume z volume",
                             "xy wiggle 1 0.2 yz final 0.5 remap none"}) {
    const std::string text =
        script_text({.before_motion = fmt::format("fix box all deform 1 {}\n", deform)}) + "run 200\n";
    expect_same(text, {{1, "* * *"}, {2, "1 2 1"}});
  }
}

// In a triclinic box LAMMPS rounds positions as it reads them.
TEST_F(InShear, ARestartAcrossPeriodicBordersGoesOn) {
  const auto last_frame = [&](const std::string& text, int processes) {
    const Ran ran = script(text, processes);
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    const std::string dump = read("dump.txt");
    return std::pair(dump.substr(dump.rfind("ITEM: TIMESTEP")), thermo(ran.out).back());
  };
  for (const bool is_triclinic : {false, true}) {
    (void)file("data.txt", data_text({.is_triclinic = is_triclinic}));
    const auto truth = last_frame(script_text() + "run 50\nwrite_restart restart\nrun 50\n", 2);
    for (const int processes : {1, 3}) {
      const auto again =
          last_frame(script_text({.style = "", .read = "read_restart restart\n" + shapes_fix}) + "run 50\n", processes);
      EXPECT_TRUE(is_triclinic || again.first == truth.first) << processes;
      expect_near({again.second}, {truth.second}, 1e-9);
    }
  }
}

/// The virial's pressure and shear stress of a sheared crate after a time of 0.05.
struct Stress {
  double pressure, shear;
};

// Where the border lies says nothing, but that LAMMPS's box stands still for the first step: an error of the order of the step.
TEST_F(InShear, TheBorderIsNowhere) {
  const auto stress = [&](const Vec3<double>& moved, double step) {
    (void)file("data.txt", data_text({.side = 4, .spacing = 0.85, .shear_rate = 2, .moved = moved}));
    const Ran ran = script(script_text({.before_motion = fmt::format("compute v all pressure NULL virial\ntimestep {}\n"
                                                                     "fix shear all deform 1 xy erate 2 remap v\n",
                                                                     step),
                                        .thermo = "c_v[1] c_v[4]"}) +
                           fmt::format("run {}\n", std::lround(0.05 / step)));
    EXPECT_EQ(ran.code, 0) << errors(ran.out);
    const auto table = thermo(ran.out);
    const std::vector<double> last = table.empty() ? std::vector<double>() : table.back();
    return last.size() == 4 ? Stress{last[2], last[3]} : Stress{};
  };
  const auto apart = [&](double step) {
    const Stress one = stress({0, 0, 0}, step), other = stress({0.2, 0.4, 0.3}, step);
    EXPECT_NEAR(one.pressure, other.pressure, 0.01 * one.pressure);
    return std::hypot(one.pressure - other.pressure, one.shear - other.shear);
  };
  const double coarse = apart(1e-3), fine = apart(1e-4);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, 0.15 * coarse);
}

}  // namespace
}  // namespace plumb::scene
