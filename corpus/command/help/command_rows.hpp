// Every command of plumb, once: whoever lists, explains or completes them reads its row.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace plumb {

struct CommandRow {
  std::string_view name, group, summary;
  std::string_view examples;  ///< a line each: the arguments, "  # ", what they do
};

inline constexpr std::array<CommandRow, 22> command_rows{{
    {"solve", "A contact", "solve the contact of each case, by one method or all of them",
     "pair.json  # the contact of a pair, by auto\n"
     "pair.json --method all  # by every method, one below the other\n"
     "pairs.jsonl --json  # one object a case, for programs"},
    {"methods", "A contact", "the methods, and the problem that each one solves", "  # names, and the problem of each"},
    {"certify", "A contact", "prove the overlap, the normal and the points of a case",
     "pair.json  # bounds that hold for sure\n"
     "pair.json --digits 20  # as many digits"},
    {"check", "A contact", "judge anybody's answer to a case",
     "pair.json --answer answer.json  # is that answer right?"},
    {"doctor", "A solver of your own", "whether a foreign solver's adapter is sane, before all else",
     "--solver ./libmine.so  # a shared library\n"
     "--solver-command 'python3 mine.py'  # a program"},
    {"campaign", "A solver of your own", "random cases by the thousand, every wrong answer kept",
     "--solver ./libmine.so --family ellipsoid --cases 1000 --seed 1 --out DIR  # one solver on one family\n"
     "--family all --cases 1000 --seed 1 --method all --out DIR  # plumb's own methods"},
    {"campaign-mpi", "A solver of your own", "the same over the processes of mpirun",
     "--family ellipsoid --cases 100000 --seed 1 --method auto --out DIR  # behind mpirun -n 8"},
    {"families", "A solver of your own", "the families that random cases come from", "  # names, and what they draw"},
    {"merge", "A solver of your own", "put campaigns that ran apart together",
     "shard-1 shard-2 --out whole  # two shards of one campaign"},
    {"fuzz", "A solver of your own", "guided fuzzing of a solver until it is wrong; the case, shrunk",
     "--solver ./libmine.so --minutes 2  # until an answer is wrong\n"
     "--solver ./libmine.so --accuracy 0.01deg  # by more than that"},
    {"path", "A solver of your own", "follow a motion step by step, cold and warm, and judge how the answers change",
     "corpus/cases/hard/paths --method auto  # the motions of the hard set"},
    {"replay", "Kept cases", "run kept cases against what they expect",
     "DIR/failures --solver ./libmine.so  # after a change of the solver\n"
     "corpus/cases  # plumb's own"},
    {"shrink", "Kept cases", "the simplest case with the same defect",
     "CASE --solver ./libmine.so --out simple.json  # what of the pair matters"},
    {"promote", "Kept cases", "move a kept case on: open, incubating, regressions",
     "corpus/cases/open/CASE.json --to incubating --why 'mended in 1a2b3c4'  # it fails no more"},
    {"ladder", "Kept cases", "the hard cases, step by step; freezes them with their certificates",
     "needle --step 3  # one case of it"},
    {"report", "Kept cases", "one page of HTML from campaigns",
     "DIR -o page.html  # of a campaign\n"
     "--issue CASE --solver ./libmine.so  # the text of a bug report"},
    {"scene", "Scenes", "a scene of bodies: which effects run, why, what each costs",
     "scene.json --plan  # which effects it calls for\n"
     "scene.json --out DIR  # run it"},
    {"scenes", "Scenes", "the named scenes, and each as a file",
     "pile --bodies 100 >pile.json  # a scene of a hundred bodies"},
    {"import", "Scenes", "the pairs of a LAMMPS or LIGGGHTS dump that touch, as cases",
     "packing.lammpstrj -o pairs.jsonl  # its touching pairs"},
    {"export", "Scenes", "cases or a scene as a dump for LAMMPS, LIGGGHTS and OVITO",
     "pairs.jsonl -o pairs.lammpstrj  # to look at them in OVITO"},
    {"export-lammps", "Scenes", "a scene as input for plumb lammps", "pile.json -o DIR  # in.lammps and data.lammps"},
    {"lammps", "Scenes", "LAMMPS with pair_style plumb/cn: scenes on many processes",
     "-in in.lammps  # behind mpirun -n 8, for many processes"},
}};

/// Null where there is none of that name.
[[nodiscard]] const CommandRow* find_command(std::string_view name);

/// "plumb replay" -> what --help shows below its options; empty where the row has no example.
[[nodiscard]] std::string examples_text(std::string_view command);

}  // namespace plumb
