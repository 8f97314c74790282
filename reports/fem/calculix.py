"""Two bodies pressed into each other, in CalculiX: the deck, the run, what is read of it.

Frictionless, linear elastic, both bodies of one material with Young's modulus 1; forces scale with it. Both meshes stand where the bodies
are, overlapping, and nothing is moved: CalculiX lets the overlap come in over the step. Of each body the far half is held.
"""

import ctypes
import dataclasses
import inspect
import io
import os
import re
import signal
import subprocess

import numpy as np

from mesh import FACES

YOUNG, POISSON = 1.0, 0.3
MODULUS = YOUNG / (2 * (1 - POISSON**2))  # of a contact of the two: 1 / sum of (1 - nu^2) / E


class EngineFailure(Exception):
    """CalculiX did not come to an end, or its output is not what was asked for."""


@dataclasses.dataclass(frozen=True)
class Setting:
    """What a result should not depend on, beside the mesh."""

    penalty: float = 300  # of the contact: stiffness / (Young's modulus / the patch's narrow radius)
    increments: int = 4
    is_swapped: bool = False  # body 1 is the slave
    held: float = 0  # nodes at most this part of the way from the centre to the contact are held
    solver: str = "ITERATIVE CHOLESKY"


@dataclasses.dataclass(frozen=True)
class Zone:
    """Where the bodies touch."""

    point: np.ndarray
    narrow: float  # of the patch's two radii the lesser, about
    reach: float  # half of the lens's length; the patch, which has half its area, is within
    across: np.ndarray | None = None  # the normal of the planes behind which bodies are held; None: from each centre to the point

    def held_towards(self, centre):
        """The point, or what of it is along the normal given."""
        return self.point if self.across is None else centre + (self.point - centre) @ self.across * self.across


@dataclasses.dataclass
class Result:
    """In the world. Forces in units of Young's modulus x length^2, moments about the origin."""

    forces: np.ndarray  # 2 x 3: of the contact on body 1 and on body 2, by the reactions of what is held
    moments: np.ndarray  # 2 x 3, of the same
    contact_force: np.ndarray  # 3, on body 2, by the contact elements
    middle: np.ndarray  # 3, of the area in contact
    area: float  # in contact
    iterations: int
    nodes: int
    displacements: list = dataclasses.field(default_factory=list)  # of each body, n x 3, where they were asked for

    def to_json(self):
        """Without the displacements."""
        fields = vars(self) | {"displacements": []}
        return {name: value.tolist() if isinstance(value, np.ndarray) else value for name, value in fields.items()}

    @staticmethod
    def from_json(fields):
        return Result(**{name: np.array(value) if isinstance(value, list) else value for name, value in fields.items()})


def _number(x):
    """At most 19 characters: CalculiX reads fields of 20 and cuts longer ones without a word."""
    return f"{x:.12e}"


def _rows(integers, width=12):
    """Lines of a set."""
    return "".join(
        ", ".join(str(k) for k in integers[i : i + width]) + ",\n" for i in range(0, len(integers), width)
    )


def held_nodes(mesh, centre, contact, part):
    along = (contact - centre) / np.dot(contact - centre, contact - centre)
    return np.flatnonzero((mesh.nodes - centre) @ along <= part)


def deck_of(meshes, centres, zone, setting, is_shown=False):
    """The input file. Displacements are asked for where they are to be shown."""
    with io.StringIO() as out:
        nodes, elements = 0, 0
        for body, (mesh, centre) in enumerate(zip(meshes, centres), start=1):
            kind = "C3D10" if mesh.elements.shape[1] == 10 else "C3D4"
            out.write(f"*NODE, NSET=ALL{body}\n")
            for k, place in enumerate(mesh.nodes.tolist(), start=nodes + 1):
                out.write(f"{k}, " + ", ".join(map(_number, place)) + "\n")
            out.write(f"*ELEMENT, TYPE={kind}, ELSET=BODY{body}\n")
            for k, of in enumerate((mesh.elements + nodes + 1).tolist(), start=elements + 1):
                out.write(f"{k}, " + ", ".join(map(str, of)) + "\n")
            out.write(f"*SURFACE, NAME=SKIN{body}, TYPE=ELEMENT\n")
            near = _near_faces(mesh, zone)
            out.writelines(f"{element + elements + 1}, S{face}\n" for element, face in near.tolist())
            held = held_nodes(mesh, centre, zone.held_towards(centre), setting.held) + nodes + 1
            out.write(f"*NSET, NSET=HELD{body}\n" + _rows(held.tolist()))
            nodes += len(mesh.nodes)
            elements += len(mesh.elements)
        out.write(_step(zone.narrow, setting, is_shown))
        return out.getvalue()


def _near_faces(mesh, zone):
    """Faces of the surface by the contact: pairing costs by those that it goes through, and no others touch."""
    of = np.take_along_axis(mesh.elements[mesh.faces[:, 0]], FACES[mesh.faces[:, 1] - 1], axis=1)
    distance = np.linalg.norm(mesh.nodes[of] - zone.point, axis=2).min(axis=1)
    return mesh.faces[distance < max(2.2 * zone.narrow, zone.reach)]


def _step(narrow, setting, is_shown):
    slave, master = ("SKIN1", "SKIN2") if setting.is_swapped else ("SKIN2", "SKIN1")
    part = _number(1 / setting.increments)
    shown = "*NODE PRINT, NSET=ALL{0}, FREQUENCY=1000\nU\n"
    return (
        f"*MATERIAL, NAME=ELASTIC\n*ELASTIC\n{YOUNG}, {POISSON}\n"
        "*SOLID SECTION, ELSET=BODY1, MATERIAL=ELASTIC\n*SOLID SECTION, ELSET=BODY2, MATERIAL=ELASTIC\n"
        "*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n"
        f"{_number(setting.penalty * YOUNG / narrow)}\n"
        f"*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\n{slave}, {master}\n"
        "*BOUNDARY\nHELD1, 1, 3\nHELD2, 1, 3\n"
        f"*STEP, NLGEOM, INC=1000\n*STATIC, SOLVER={setting.solver}\n{part}, 1., 1e-6, {part}\n"
        + "".join(f"*NODE PRINT, NSET=HELD{body}, FREQUENCY=1000\nRF\n" for body in (1, 2))
        + "".join(shown.format(body) for body in (1, 2) if is_shown)
        + f"*CONTACT PRINT, FREQUENCY=1000, SLAVE={slave}, MASTER={master}\nCF\n*END STEP\n"
    )


def die_with_parent():
    """This process ends where the one that made it ends, however that is (Linux)."""
    set_death_signal = 1  # PR_SET_PDEATHSIG, prctl(2)
    ctypes.CDLL(None).prctl(set_death_signal, signal.SIGKILL)


def run(folder, deck, meshes, setting):
    """The result of one calculation; its files stay in `folder`, a pathlib.Path. EngineFailure where it does not end."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "contact.inp").write_text(deck, encoding="ascii")
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    done = subprocess.run(
        ["ccx", "contact"], cwd=folder, env=environment, capture_output=True, text=True, errors="replace", check=False,
        preexec_fn=die_with_parent,
    )  # fmt: skip
    (folder / "contact.log").write_text(done.stdout + done.stderr)
    if done.returncode != 0 or not _is_whole(folder / "contact.sta"):
        raise EngineFailure(f"{folder / 'contact.log'}: ccx did not reach the end of the step")
    return _read(folder, meshes, setting)


def _is_whole(path):
    """Whether the last increment of the step's summary ends at 1."""
    lines = path.read_text().splitlines() if path.exists() else []
    return len(lines) > 2 and abs(float(lines[-1].split()[4]) - 1) < 1e-9


def _read(folder, meshes, setting):
    text = (folder / "contact.dat").read_text()
    offset, forces, moments, displacements = 0, [], [], []
    for body, mesh in enumerate(meshes, start=1):
        numbers, reactions = _table(text, f"forces (fx,fy,fz) for set HELD{body} ")
        forces.append(-reactions.sum(axis=0))
        moments.append(-np.cross(mesh.nodes[numbers - 1 - offset], reactions).sum(axis=0))
        if " for set ALL" in text:
            displacements.append(_table(text, f"displacements (vx,vy,vz) for set ALL{body} ")[1])
        offset += len(mesh.nodes)
    sign = -1 if setting.is_swapped else 1  # the slave is body 2, or 1
    return Result(
        np.array(forces),
        np.array(moments),
        sign * _line_after(text, "total surface force (fx,fy,fz)")[:3],
        _line_after(text, "center of gravity and mean normal")[:3],
        float(_line_after(text, "area,  normal force")[0]),
        len((folder / "contact.cvg").read_text().splitlines()) - 4,
        offset,
        displacements,
    )


def reading():
    """The text of what reads: what is kept of a calculation is no longer right where this has changed."""
    return "".join(map(inspect.getsource, (Result, _read, _table, _line_after)))


def _table(text, heading):
    """Node numbers and three values each, of the last table with this heading."""
    if heading not in text:
        raise EngineFailure(f"contact.dat has no {heading.strip()}")
    rows = text[text.rindex(heading) :].split("\n", 2)[2]
    lines = re.match(r"(?: +\d+(?: +[-+.\dE]+){3}\n)*", rows).group().splitlines()
    values = np.array([line.split() for line in lines], float).reshape(-1, 4)
    return values[:, 0].astype(int), values[:, 1:]


def _line_after(text, heading):
    if heading not in text:
        raise EngineFailure(f"contact.dat has no {heading}")
    return np.array(text[text.rindex(heading) :].split("\n")[2].split(), float)
