// The programs themselves: what they print, the one line on stderr, the exit code.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

#include "corpus/solvers/solver.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/interrupting.hpp"

namespace plumb {
namespace {

TEST_F(Commands, UnusableCasesAreOneLineAndTwo) {
  const std::string body = "bodies[1].shape.superellipsoid.";
  (void)file("axis.json", sample_with("[1, 1, 1]", "[1, 0, 1]"));
  expect_refusal("solve axis.json", "axis.json: " + body + "semi_axes[1]: must be finite and above 0");
  (void)file("minus.json", sample_with("[1, 1, 1]", "[-1, 1, 1]"));
  expect_refusal("solve minus.json", "minus.json: " + body + "semi_axes[0]: must be finite and above 0");
  (void)file("exponent.json", sample_with("[2, 2]", "[2, 1]"));
  expect_refusal("solve exponent.json", "exponent.json: " + body + "exponents[1]: must be finite and above 1");
  (void)file("zero.json", sample_with("[1, 0, 0, 0]", "[0, 0, 0, 0]"));
  expect_refusal("solve zero.json", "zero.json: bodies[0].orientation.quaternion_wxyz: must not be zero");
  (void)file("three.json", R"({"format": "plumb/case-1", "bodies": [1, 2, 3]})");
  expect_refusal("solve three.json", "three.json: bodies: must be an array of 2 bodies, not 3");
  (void)file("unknown.json", sample_plus(R"("colour": 1)"));
  expect_refusal("solve unknown.json", "unknown.json: colour: unknown field");
}

TEST_F(Commands, NumbersThatJsonDoesNotHaveAreOneLineAndTwo) {
  for (const char* number : {"NaN", "Infinity", "-Infinity", "nan", "1e999"}) {
    (void)file("a.json", sample_with("1.5", number));
    const Ran ran = plumb("solve a.json 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << number;
    EXPECT_TRUE(ran.out.starts_with("a.json: bodies[1].position[0]: broken JSON: ")) << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(Commands, FilesThatCannotBeReadOrWritten) {
  (void)file("good.json", sample_case());
  expect_refusal("solve none.json", "none.json: No such file or directory");
  expect_refusal("solve .", ".: Is a directory");
  expect_refusal("replay none", "none: No such file or directory");
  expect_refusal("replay good.json --junit none/a.xml", "none/a.xml: No such file or directory");
  fs::create_directory(path_ / "empty");
  expect_refusal("replay empty", "empty: holds no case");
  expect_refusal("check good.json --answer none", "none: No such file or directory");
}

TEST_F(Commands, WhatCannotBePrintedIsOneLineAndTwo) {
  (void)file("good.json", sample_case());
  for (const char* arguments : {"solve good.json", "methods", "replay good.json", "solve --help", "methods --help",
                                "check --help", "replay --help"}) {
    const Ran full = plumb(std::string(arguments) + " 2>&1 >/dev/full");
    EXPECT_EQ(full.code, 2) << arguments;
    EXPECT_EQ(full.out, "standard output: No space left on device\n") << arguments;
  }
}

TEST_F(Commands, UsageErrorsAreOneLineAndTwo) {
  (void)file("good.json", sample_case());
  for (const char* arguments :
       {"solve", "solve good.json --metod auto", "solve good.json --method nobody", "solve good.json --want depth",
        "solve good.json --repeat 0", "nonsense", "--nonsense", "check good.json", "replay"}) {
    const Ran ran = plumb(std::string(arguments) + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(Commands, ABadLineStopsAfterTheAnswersBeforeIt) {
  (void)file("a.jsonl", sample_case() + "\n" + sample_case() + "\n{\"format\": 1}\n" + sample_case() + "\n");
  const Ran answers = plumb("solve a.jsonl --json 2>/dev/null");
  EXPECT_EQ(answers.code, 2);
  EXPECT_EQ(lines_of(answers.out).size(), 2U);
  expect_refusal("solve a.jsonl --json", "a.jsonl:3: format: must be a string, not a number");
  const Ran piped = plumb("solve - --json <a.jsonl 2>&1 >/dev/null");
  EXPECT_EQ(piped.out, "standard input:3: format: must be a string, not a number\n");
}

TEST_F(Commands, ASingleCaseOverSeveralLinesComesThroughAPipe) {
  (void)file("a.json", Json::parse(sample_case()).dump(2) + "\n");
  const Ran ran = plumb("solve - --json <a.json");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
}

TEST_F(Commands, ASingleCaseOverSeveralLinesIsReadFromAnySource) {
  const std::string pretty = "\n \n" + Json::parse(sample_case()).dump(2) + "\n";
  (void)file("a.json", pretty);
  (void)file("a.jsonl", pretty);
  for (const char* arguments : {"solve a.json --json", "solve a.jsonl --json", "solve - --json <a.json"}) {
    const Ran ran = plumb(arguments);
    EXPECT_EQ(ran.code, 0) << arguments;
    EXPECT_EQ(lines_of(ran.out).size(), 1U) << arguments;
  }
}

TEST_F(Commands, WhatIsWrongInACaseOverSeveralLinesIsNamedThrough) {
  (void)file("a.json", Json::parse(sample_with("[1, 1, 1]", "[1, 0, 1]")).dump(2));
  const std::string reason = "standard input: bodies[1].shape.superellipsoid.semi_axes[1]: must be finite and above 0";
  EXPECT_EQ(plumb("solve - <a.json 2>&1 >/dev/null").out, reason + "\n");
  (void)file("a.json", "{\n  \"format\": NaN\n}\n");
  EXPECT_TRUE(plumb("solve - <a.json 2>&1").out.starts_with("standard input: format: broken JSON: NaN"));
  // A line that was cut off stays a bad line.
  (void)file("a.jsonl", "{\"format\":\n" + sample_case() + "\n");
  EXPECT_TRUE(plumb("solve a.jsonl 2>&1").out.starts_with("a.jsonl:1: format: broken JSON: "));
}

TEST_F(Commands, SolveAnswersWithTheContractsFields) {
  (void)file("a.json", sample_case());
  const Json answer = lines_of(plumb("solve a.json --json --repeat 3 --warm").out).at(0);
  for (const char* key : {"name", "method", "status", "verdict", "overlap", "normal", "points", "contact_point",
                          "iterations", "evaluations", "angles_deg", "residuals", "timing"})
    EXPECT_TRUE(answer.contains(key)) << key;
  EXPECT_FALSE(answer.contains("curvature"));
  EXPECT_NEAR(answer["overlap"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(answer["normal"][0].get<double>(), 1, 1e-12);
}

TEST_F(Commands, WhatIsNotWantedIsAbsent) {
  (void)file("a.json", sample_case());
  const Json answer = lines_of(plumb("solve a.json --json --want overlap").out).at(0);
  for (const char* key : {"normal", "points", "contact_point", "angles_deg", "residuals", "curvature", "derivatives"})
    EXPECT_FALSE(answer.contains(key)) << key;
  const Json yes_or_no = lines_of(plumb("solve a.json --json --want verdict").out).at(0);
  EXPECT_FALSE(yes_or_no.contains("overlap"));
  EXPECT_EQ(yes_or_no["verdict"], answer["verdict"]);
}

TEST_F(Commands, DerivativesAreThoseOfBothBodies) {
  (void)file("a.json", sample_case());
  const Json answer = lines_of(plumb("solve a.json --json --want normal,derivatives").out).at(0);
  ASSERT_EQ(answer["derivatives"].size(), 2U);
  EXPECT_EQ(answer["derivatives"][0]["overlap_by_shift"], answer["normal"]);
  EXPECT_EQ(answer["derivatives"][1]["normal_by_turn"].size(), 3U);
}

TEST_F(Commands, AllMethodsAnswerInTheOrderOfTheList) {
  (void)file("a.json", sample_case());
  const auto answers = lines_of(plumb("solve a.json --json --method all").out);
  EXPECT_EQ(answers.size(), all_solvers().size());
  const Ran list = plumb("methods");
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(static_cast<std::size_t>(std::count(list.out.begin(), list.out.end(), '\n')), all_solvers().size());
}

TEST_F(Commands, TheTableFitsEightyColumns) {
  (void)file("a.json", sample_case());
  for (const char* arguments :
       {"solve a.json", "solve a.json --method all", "solve a.json --want curvature,derivatives"}) {
    const std::string table = plumb(arguments).out;
    for (std::size_t begin = 0, end = 0; (end = table.find('\n', begin)) != std::string::npos; begin = end + 1)
      EXPECT_LE(end - begin, 80U) << table.substr(begin, end - begin);
  }
}

TEST_F(Commands, RealPairsAllSolve) {
  const Ran ran = run(fmt::format("for f in {}/*.json; do {} solve $f --json || exit 9; done",
                                  std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/real", plumb_program));
  EXPECT_EQ(ran.code, 0);
  const auto answers = lines_of(ran.out);
  EXPECT_EQ(answers.size(), 21U);
  for (const Json& answer : answers) EXPECT_EQ(answer["status"], "converged") << answer["name"];
}

TEST_F(Commands, ForeignSolversAreLoadedAndAsked) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  (void)file("a.json", sample_case());
  const auto answers = lines_of(plumb("solve a.json --json --solver " + folder + "foreign_sphere.so").out);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0]["method"], "solver:foreign_sphere.so");
  EXPECT_EQ(answers[0]["overlap"], 0.5);
  (void)file("b.json", sample_with("[1, 1, 1]", "[1, 1, 2]"));
  const auto refused = lines_of(plumb("solve b.json --json --solver " + folder + "foreign_sphere.so").out);
  EXPECT_EQ(refused.at(0)["status"], "invalid_input");
  EXPECT_FALSE(refused.at(0).contains("overlap"));
}

TEST_F(Commands, LibrariesThatAreNoSolversAreRefused) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  (void)file("a.json", sample_case());
  expect_refusal("solve a.json --solver " + folder + "foreign_future.so",
                 folder + "foreign_future.so: plumb_solver_version: is 3, must be 1 or 2");
  expect_refusal("solve a.json --solver " + folder + "foreign_mute.so",
                 folder +
                     "foreign_mute.so: plumb_solver_solve: not exported by the library (see solver/plumb_solver.h)");
  EXPECT_EQ(plumb("solve a.json --solver none.so 2>/dev/null").code, 2);
}

TEST_F(Commands, CtrlCEndsAWaitingCommandWith130) {
  const fs::path input = path_ / "input", answers = path_ / "answers";
  ASSERT_EQ(mkfifo(input.c_str(), 0600), 0);
  // Open in both directions, so that it stays open while the command waits for more.
  std::fstream feeder(input, std::ios::in | std::ios::out);
  feeder << sample_case() << '\n' << std::flush;
  const pid_t child =
      start_command("exec " + plumb_program + "solve - --json <" + input.string() + " >" + answers.string());
  const auto has_answered = [&](pid_t) { return fs::exists(answers) && fs::file_size(answers) > 0; };
  EXPECT_EQ(interrupt_when(child, has_answered), 130);
  EXPECT_EQ(lines_of(read("answers")).size(), 1U);
}

TEST_F(Commands, PlumbAloneListsItsCommands) {
  const Ran ran = plumb("");
  EXPECT_EQ(ran.code, 0);
  for (const char* name : {"  solve ", "  methods ", "  check ", "  replay "})
    EXPECT_NE(ran.out.find(name), std::string::npos) << ran.out;
  EXPECT_TRUE(plumb("--version").out.starts_with("plumb "));
  EXPECT_EQ(plumb("solve --help").code, 0);
  EXPECT_EQ(plumb("-V").out, plumb("--version").out);
  expect_refusal("frobnicate", "plumb: no command 'frobnicate' (plumb --help lists them)");
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) out.push_back(part);
  return out;
}

TEST_F(Commands, HelpOfACommandIsItsOwn) {
  const Ran ran = plumb("help replay");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out, plumb("replay --help").out);
  for (const char* of_itself : {"help --help", "help -h", "help help", "--help --help"})
    EXPECT_EQ(plumb(of_itself).out, plumb("--help").out) << of_itself;
  expect_refusal("help frobnicate", "plumb: no command 'frobnicate' (plumb --help lists them)");
}

/// What OpenMP hears of a program's threads.
TEST_F(Commands, ThreadsThatWaitSleepUnlessTheCallerSaysElse) {
  (void)file("tell.sh", "printenv OMP_WAIT_POLICY >said\n");
  (void)file("good.json", sample_case());
  for (const auto& [setting, said] : {std::pair("", "passive\n"), std::pair("OMP_WAIT_POLICY=active ", "active\n")}) {
    (void)run("cd " + path_.string() + " && " + setting + plumb_program +
              "solve good.json --solver-command 'sh tell.sh' 2>&1");
    EXPECT_EQ(run("cat " + (path_ / "said").string()).out, said);
  }
}

/// Each shows examples of itself, and each option in them is one that it has.
TEST_F(Commands, EveryHelpHasExamples) {
  for (const std::string& line : parts_of(plumb("--commands").out, '\n')) {
    const std::string name = line.substr(0, line.find('\t'));
    if (name == "lammps") {  // its options are LAMMPS's own
      EXPECT_NE(plumb("lammps --help").out.find("Usage: plumb lammps -in FILE"), std::string::npos);
      continue;
    }
    const std::string help = plumb(name + " --help").out, mark = "\nExamples:\n";
    const std::size_t at = help.find(mark);
    ASSERT_NE(at, std::string::npos) << name;
    const std::string options = help.substr(0, at);
    for (const std::string& example : parts_of(help.substr(at + mark.size()), '\n')) {
      if (!example.starts_with("  plumb")) continue;
      for (const std::string& word : parts_of(example, ' ')) {
        if (!word.starts_with("-")) continue;
        EXPECT_NE(options.find(word), std::string::npos) << name << " has no " << word;
      }
    }
  }
}

TEST_F(Commands, AWordThatIsNearlyOneIsTold) {
  expect_refusal("repaly", "plumb: no command 'repaly' (did you mean 'replay'?)");
  expect_refusal("replay --metod auto x",
                 "plumb replay: --metod: no such option (did you mean '--method'?) (--help tells more)");
  expect_refusal("solve --jsn", "plumb solve: --jsn: no such option (did you mean '--json'?) (--help tells more)");
}

/// Whatever list a name is of.
TEST_F(Commands, ANameThatIsNearlyOneIsTold) {
  const auto hints = [this](const std::string& arguments, const std::string& refusal) {
    const Ran ran = plumb(arguments + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_NE(ran.out.find(refusal + "'?); "), std::string::npos) << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  };
  (void)file("a.json", sample_case());
  hints("solve a.json --method atuo", "--method: atuo: no such method (did you mean 'auto");
  hints("solve a.json --want nromal", "--want: nromal: no such field (did you mean 'normal");
  hints("certify a.json --effort prof", "plumb certify: --effort: prof: no such effort (did you mean 'proof");
  hints("import a.dump --format lamps", "plumb import: --format: lamps: no such format (did you mean 'lammps");
  hints("import a.dump --column quatv=x", "--column: quatv: no such role (did you mean 'quatw");
  hints("promote a.json --to opne --why x", "plumb promote: --to: opne: no such folder (did you mean 'open");
  hints("ladder nedle", "plumb ladder: LADDER: nedle: no such ladder (did you mean 'needle");
  hints("scenes pyle", "pyle: no such scene (did you mean 'pile");
  hints("scene a.json --force gravitty", "plumb scene: --force: gravitty: no such effect (did you mean 'gravity");
  hints("campaign --family elipsoid --cases 1 --out out",
        "--family: elipsoid: no such family (did you mean 'ellipsoid");
  hints("fuzz --method auto --kinds misalined",
        "--kinds: PLUMB_FUZZ_ABORT: misalined: no such finding (did you mean 'misaligned");
}

TEST_F(Commands, BashCompletesCommandsAndOptions) {
  const auto completed = [](const std::string& words, int at) {
    return run("PATH=" PLUMB_BINARY_DIR "/bin:$PATH bash -c '. " PLUMB_SOURCE_DIR
               "/corpus/command/help/shell/plumb.bash; COMP_WORDS=(" +
               words + "); COMP_CWORD=" + std::to_string(at) + "; _plumb; printf \"%s\\n\" \"${COMPREPLY[@]}\"'")
        .out;
  };
  EXPECT_EQ(completed("plumb repl", 1), "replay\n");
  EXPECT_EQ(completed("plumb hel", 1), "help\n");
  EXPECT_EQ(completed("plumb help shr", 2), "shrink\n");
  EXPECT_EQ(completed("plumb replay --acc", 2), "--accuracy\n");
}

/// At its own prompt: what the line is once the tabulator was pressed.
TEST_F(Commands, ZshCompletesCommandsAndOptions) {
  if (run("command -v zsh").code != 0) GTEST_SKIP() << "needs zsh";
  const auto completes = [this](const std::string& typed, const std::string& line) {
    (void)file("ask.zsh", "zmodload zsh/zpty; zpty shell zsh -f -i\n"
                          "zpty -w shell 'zle_highlight=(suffix:none); fpath=(" PLUMB_SOURCE_DIR
                          "/corpus/command/help/shell $fpath)'\n"
                          "zpty -w shell 'autoload -U compinit; compinit -u -D; print rea\"\"dy'\n"
                          "zpty -r shell said '*ready*'; zpty -w -n shell $'" +
                              typed +
                              "\\t'\n"
                              "zpty -r shell said '*" +
                              line + " *' && print found\n");
    const std::string path = "PATH=" PLUMB_BINARY_DIR "/bin:$PATH ";
    EXPECT_EQ(run("cd " + path_.string() + " && " + path + "timeout 20 zsh -f ask.zsh").out, "found\n") << typed;
  };
  completes("plumb repl", "plumb replay");
  completes("plumb hel", "plumb help");
  completes("plumb help shr", "plumb help shrink");
  completes("plumb replay --acc", "plumb replay --accuracy");
}

}  // namespace
}  // namespace plumb
