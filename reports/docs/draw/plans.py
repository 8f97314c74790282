"""Pictures of what goes where: boxes and arrows, for what has no shape of its own."""
from svg import BODY1, BODY2, INK, RIGHT, SOFT, WRONG, Plan


def rooms():
    """The five rooms; each may use those below it."""
    plan = Plan(640, 330, "The five rooms: each may use those below it")
    rows = [
        ("reports/", "shows", "pages, tables, benchmarks, documentation"),
        ("fuzz/", "hunts", "targets, mutator, campaign, shrink, peers"),
        ("properties/", "judges", "laws, generators, the test suite"),
        ("corpus/", "keeps", "case files, their only reader and writer"),
        ("solver/", "solves", "methods, reference, scenes, the ways in"),
    ]
    for row, (name, verb, what) in enumerate(rows):
        top = 14 + 62 * row
        plan.box((20, top), (470, 48), (f"{name} {verb}", what), BODY2 if row < 4 else BODY1, BODY2 if row < 4 else BODY1)
        if row:
            plan.line_to((255, top - 14), (255, top))
    plan.line_to((490, 38), (545, 38), (545, 286), (492, 286))
    for row in (1, 2, 3):
        plan.line_to((545, 38 + 62 * row), (492, 38 + 62 * row))
    plan.label((556, 166), "may use", SOFT, 13)
    return plan


def fuzz_loop():
    plan = Plan(640, 300, "The loop of a guided fuzzer")
    top = [("seeds", "fuzz/seeds"), ("mutator", "knows the fields"), ("bytes", "a layout"), ("a legal pair", "whatever the bytes")]
    for column, words in enumerate(top):
        plan.box((16 + 158 * column, 20), (134, 54), words, BODY1, BODY1)
        if column:
            plan.line_to((150 + 158 * (column - 1), 47), (174 + 158 * (column - 1), 47))
    plan.line_to((557, 74), (557, 124))
    bottom = [("the solver", "auto, or yours"), ("the laws", "with the reference"), ("finding", "a case file, stop")]
    for column, words in enumerate(bottom):
        colour = WRONG if column == 2 else BODY2
        plan.box((490 - 190 * column, 124), (134, 54), words, colour, colour)
    plan.line_to((490, 151), (436, 151))
    plan.line_to((300, 151), (246, 151))
    plan.label((273, 142), "wrong", WRONG, 13, "middle")
    plan.box((200, 222), (240, 58), ("is something new?", "code reached; more severe, slower"), RIGHT, RIGHT)
    plan.line_to((557, 178), (557, 251), (442, 251))
    plan.line_to((367, 178), (367, 220))
    plan.line_to((200, 251), (56, 251), (56, 110), (210, 110), (210, 76), colour=RIGHT)
    plan.label((64, 242), "kept, changed again", RIGHT, 13)
    return plan


def way_of_a_pair():
    """From where a failing pair comes to what is done with it."""
    plan = Plan(640, 300, "Where a failing pair comes from, and what is done with it")
    sources = ["campaign", "fuzz", "flight recorder", "import of a dump", "written by hand"]
    for row, words in enumerate(sources):
        plan.box((16, 18 + 54 * row), (150, 40), (words,), BODY1, BODY1)
        plan.line_to((166, 38 + 54 * row), (238, 146 + 2 * (row - 2)))
    plan.box((240, 112), (130, 68), ("a case file", "the exact pair,", "and what to expect"), INK)
    ends = [
        ("replay", "the same again?"),
        ("shrink", "the simplest pair with it"),
        ("certify", "what is true, proved"),
        ("check", "is this answer right?"),
        ("report", "a page to look at"),
    ]
    for row, words in enumerate(ends):
        plan.line_to((370, 146 + 2 * (row - 2)), (430, 38 + 54 * row))
        plan.box((432, 16 + 54 * row), (194, 44), words, RIGHT, RIGHT)
    return plan


def doors():
    """A foreign solver in processes of its own."""
    plan = Plan(640, 270, "Your solver in a process of its own, and plumb, which judges")
    plan.box((16, 20), (236, 230), ("",), BODY1)
    plan.label((134, 44), "plumb", INK, 15, "middle", "600")
    for row, words in enumerate((("pairs", "random, kept, guided"), ("laws", "on the answer alone"), ("reference", "proves what is right"))):
        plan.box((36, 58 + 62 * row), (196, 50), words, BODY1, BODY1)
    for row, (name, option) in enumerate((("a shared library", "--solver ./libmine.so"), ("a program", "--solver-command ..."))):
        top = 20 + 122 * row
        plan.box((404, top), (220, 108), ("",), BODY2)
        plan.label((514, top + 24), "a process for each thread", SOFT, 13, "middle")
        plan.box((420, top + 36), (188, 58), (name, option), BODY2, BODY2)
        plan.line_to((252, top + 40), (402, top + 40))
        plan.line_to((404, top + 72), (254, top + 72))
        plan.label((328, top + 34), "pair", SOFT, 13, "middle")
        plan.label((328, top + 90), "answer, or its end", SOFT, 13, "middle")
    return plan


def shards():
    plan = Plan(640, 250, "A campaign in three shards, and as one run")
    plan.box((16, 92), (116, 58), ("60 pairs", "family and seed"), INK)
    for row in range(3):
        top = 20 + 74 * row
        plan.line_to((132, 121), (188, top + 28))
        plan.box((190, top), (150, 56), (f"--shard {row + 1}/3", "any machine"), BODY1, BODY1)
        plan.line_to((340, top + 28), (388, top + 28))
        plan.box((390, top + 6), (86, 44), (f"shard-{row + 1}",), SOFT)
        plan.line_to((476, top + 28), (514, 121 + 4 * (row - 1)))
    plan.box((516, 88), (110, 66), ("plumb merge", "the same as", "one run"), RIGHT, RIGHT)
    plan.label((265, 242), "killed? the same line with --resume", SOFT, 13, "middle")
    return plan


def step_of_a_scene():
    plan = Plan(640, 250, "One step of a scene")
    row1 = [("kick half", "velocities"), ("drift", "positions, turns"), ("contact list", "fat boxes"), ("solver", "warm, by auto")]
    row2 = [("kick half", "velocities"), ("dashpots", "damping"), ("forces", "along the normal")]
    for column, words in enumerate(row1):
        colour = BODY2 if words[0] in ("contact list", "solver") else BODY1
        plan.box((14 + 156 * column, 24), (136, 56), words, colour, colour)
        if column:
            plan.line_to((150 + 156 * (column - 1), 52), (168 + 156 * (column - 1), 52))
    plan.line_to((550, 80), (550, 144))
    for column, words in enumerate(reversed(row2)):
        plan.box((482 - 156 * column, 146), (136, 56), words, BODY1, BODY1)
        if column:
            plan.line_to((482 - 156 * (column - 1), 174), (464 - 156 * (column - 1), 174))
    plan.line_to((170, 174), (82, 174), (82, 82))
    plan.label((20, 200), "the next step", SOFT, 13)
    plan.label((320, 236), "orange: what contacts cost; gone where no effect needs a contact", SOFT, 13, "middle")
    return plan


def batch():
    plan = Plan(640, 300, "Four pairs side by side in one register")
    for column, name in enumerate(("semi_axes", "position", "quaternion")):
        left = 16 + 78 * column
        plan.label((left + 34, 26), name, SOFT, 12.5, "middle")
        for row in range(8):
            colour = BODY1 if row < 4 else SOFT
            plan.box((left, 34 + 28 * row), (68, 24), ("",), colour, colour if row < 4 else "none")
    plan.label((126, 284), "arrays: a row is a pair", SOFT, 13, "middle")
    plan.box((304, 30), (124, 120), ("",), BODY1)
    plan.label((366, 172), "one register,", SOFT, 13, "middle")
    plan.label((366, 190), "a lane for each pair", SOFT, 13, "middle")
    for lane in range(4):
        plan.line_to((244, 46 + 28 * lane), (310, 46 + 28 * lane))
        is_left = lane == 2
        plan.box((312, 36 + 28 * lane), (108, 22), ("",), BODY2 if is_left else BODY1, BODY2 if is_left else BODY1)
        if not is_left:
            plan.line_to((428, 46 + 28 * lane), (508, 46 + 28 * lane))
        plan.box((510, 34 + 28 * lane), (114, 24), ("",), RIGHT, RIGHT)
    plan.label((567, 26), "answers", SOFT, 13, "middle")
    plan.box((440, 216), (184, 54), ("auto, by itself", "a lane not settled"), BODY2, BODY2)
    plan.line_to((428, 103), (462, 103), (462, 214), colour=BODY2)
    plan.line_to((600, 216), (600, 148), colour=BODY2)
    return plan


def proof():
    plan = Plan(640, 290, "What searches for a proof, and what checks it")
    plan.box((16, 24), (150, 62), ("the pair", "its doubles, exact"), INK)
    plan.box((228, 24), (190, 62), ("the search", "fast; need not be right"), BODY2, BODY2)
    plan.box((474, 24), (150, 62), ("the proof", "cover and regions"), INK)
    plan.line_to((166, 55), (226, 55))
    plan.line_to((418, 55), (472, 55))
    plan.path([(16, 120), (624, 120)], SOFT, 1.2, dashes="6 4")
    plan.label((104, 140), "nothing is shared across this line", SOFT, 13)
    plan.box((384, 160), (240, 62), ("the verifier", "intervals alone; searches nothing"), RIGHT, RIGHT)
    plan.line_to((549, 86), (549, 158))
    plan.line_to((91, 86), (91, 252), (504, 252), (504, 224))
    plan.box((150, 160), (180, 62), ("certificate", "proved, disproved, open"), RIGHT)
    plan.line_to((384, 191), (332, 191))
    return plan


def balls(plan, left, right, count, colour):
    for k in range(count):
        plan.parts.append(f'<circle cx="{left + (k * 37 + 20) % (right - left - 24) + 12}" cy="{44 + (k * 53) % 124}" r="11" stroke="{colour}" '
                          f'fill="{colour}" fill-opacity="0.2"/>')


def lammps_and_plumb():
    """Two ranks with their ghosts, and which program does what."""
    plan = Plan(640, 250, "LAMMPS divides the box; plumb solves the contacts")
    for left, colour, name in ((16, BODY1, "rank 0"), (180, BODY2, "rank 1")):
        plan.box((left, 24), (164, 164), ("",), colour)
        balls(plan, left, left + 164, 9, colour)
        plan.label((left + 82, 208), name, colour, 13, "middle", "600")
    plan.path([(150, 24), (210, 24), (210, 188), (150, 188)], SOFT, 1.2, dashes="5 4", closed=True)
    plan.label((180, 232), "ghosts: both ranks know these bodies", SOFT, 13, "middle")
    rows = [
        ("LAMMPS", SOFT, ("cuts the box, sends ghosts", "neighbour lists", "dumps, thermo, MPI")),
        ("plumb", RIGHT, ("pair_style plumb/cn: contacts, forces", "fix plumb/wall: walls", "fix plumb/nve: motion")),
    ]
    for row, (name, colour, words) in enumerate(rows):
        plan.label((364, 44 + 112 * row), name, colour, 15, "start", "600")
        for line, text in enumerate(words):
            plan.label((364, 66 + 112 * row + 20 * line), text, INK, 13)
    return plan


def pictures():
    drawn = (rooms, fuzz_loop, way_of_a_pair, doors, shards, step_of_a_scene, batch, proof, lammps_and_plumb)
    return {f"{draw.__name__.replace('_', '-')}.svg": draw() for draw in drawn}
