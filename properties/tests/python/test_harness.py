"""What runs the program: certificates, campaigns, scenes, judgements; and how it is told to stop."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from decimal import Decimal

import numpy as np

import plumb
from drawn import pairs


class Certificates(unittest.TestCase):
    def test_hold_the_solver_answers(self):
        bodies = list(zip(*pairs(4)))
        for (body1, body2), certificate in zip(bodies, plumb.certify_all(bodies)):
            contact = plumb.solve(body1, body2)
            self.assertEqual(certificate.verdict, contact.verdict)
            self.assertLessEqual(certificate.overlap.lower, certificate.overlap.upper)
            self.assertAlmostEqual(float(certificate.overlap.lower), contact.overlap, delta=1e-14)
            np.testing.assert_allclose(np.array(certificate.normal, float), contact.normal, atol=1e-13)
            np.testing.assert_allclose(np.array(certificate.points, float), contact.points, atol=1e-13)
            self.assertLess(certificate.normal_radius, Decimal("1e-40"))
            self.assertEqual((certificate.unique, certificate.global_, certificate.digits), ("proved", "proved", 50))

    def test_are_those_of_the_program(self):
        body1, body2 = (bodies[0] for bodies in pairs(1, (2, 8)))
        command = [plumb.find_program(), "certify", "-", "--json", "--all"]
        case = json.dumps(plumb.case(body1, body2))
        said = json.loads(subprocess.run(command, input=case, capture_output=True, text=True, check=True).stdout)
        mine = plumb.certify(body1, body2, all=True).json
        for certificate in (said, mine):
            del certificate["timing"]
        self.assertEqual(mine, said)
        self.assertIn("stationary", mine)

    def test_say_what_is_not_proved(self):
        ball = plumb.Body((1, 1, 1), (0, 0, 0))
        certificate = plumb.certify(ball, ball)
        self.assertEqual(certificate.unique, "disproved")
        self.assertIsNone(certificate.normal)
        self.assertEqual(float(certificate.overlap.lower), 2)

    def test_other_problems(self):
        body1, body2 = (bodies[0] for bodies in pairs(1, seed=3))
        body2 = body2.moved(body2.position * 0.5)
        certificate = plumb.certify(body1, body2, problem="midway", digits=15)
        contact = plumb.solve(body1, body2, "geometric_potential_midway")
        np.testing.assert_allclose(np.array(certificate.normal, float), contact.normal, atol=1e-12)
        with self.assertRaisesRegex(ValueError, "^digits: "):
            plumb.certify(body1, body2, digits=0)


class Harness(unittest.TestCase):
    def test_a_campaign_is_the_same_again(self):
        with tempfile.TemporaryDirectory() as out:
            kept = plumb.campaign("spheroid,ellipsoid", 20, seed=5, method="auto,original_cn", out=out, threads=2)
            self.assertEqual(json.loads(pathlib.Path(out, "summary.json").read_text()), kept.summary)
        again = plumb.campaign(["spheroid", "ellipsoid"], 20, seed=5, method=["auto", "original_cn"], threads=1)
        for result in (kept, again):
            del result.summary["timing"], result.summary["host"]
        self.assertEqual(again.summary, kept.summary)
        self.assertEqual(again.failures, kept.failures)
        self.assertFalse(kept.found)
        self.assertIn("original_cn", kept.table)

    def test_a_failure_goes_from_hand_to_hand(self):
        failures = plumb.campaign("spheroid", 10, method="original_cn").failures
        failure = next(case for case in failures if case["expect"]["finding"] == "misaligned")
        body1, body2 = plumb.bodies_of(failure)
        answer = plumb.solve(body1, body2, "original_cn")
        judged = plumb.check(body1, body2, answer)
        self.assertEqual(judged["finding"], "misaligned")
        self.assertGreater(judged["severity"], 1)
        self.assertEqual(plumb.check(body1, body2, plumb.solve(body1, body2))["finding"], "none")
        self.assertEqual(plumb.shrink(failure)["finding"], "misaligned")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "kept.json")
            file.write_text(json.dumps(failure))
            self.assertFalse(plumb.replay(file).differs)
            failure["expect"]["finding"] = "none"
            file.write_text(json.dumps(failure))
            self.assertTrue(plumb.replay([folder]).differs)

    def test_a_scene(self):
        scene = plumb.named_scene("impact")
        with tempfile.TemporaryDirectory() as out:
            run = plumb.scene(scene, out=out, threads=1)
            self.assertTrue(run["complete"])
            self.assertTrue(pathlib.Path(out, "playback.jsonl").stat().st_size)
            file = pathlib.Path(out, "scene.json")
            self.assertEqual(plumb.scene_plan(file), plumb.scene_plan(scene))

    def test_unusable_input(self):
        ball = plumb.Body((1, 1, 1), (0, 0, 0))
        for text, call in (
            ("^family: cubes: ", lambda: plumb.campaign("cubes", 1)),
            ("^scene: format: missing", lambda: plumb.scene({})),
            ("^scene: nowhere.json: ", lambda: plumb.scene("nowhere.json")),
            ("^name: nothing: ", lambda: plumb.named_scene("nothing")),
            ("^answer: normal: ", lambda: plumb.check(ball, ball, {"normal": "up"})),
            ("^answer: overlp: unknown field", lambda: plumb.check(ball, ball, {"overlap": 2, "overlp": 2})),
            ("^answer: method: must be one of", lambda: plumb.check(ball, ball, {"overlap": 2, "method": "best"})),
            ("^seed: '-1' is not", lambda: plumb.campaign("spheroid", 1, seed=-1)),
            ("^paths: nowhere: ", lambda: plumb.replay("nowhere")),
            ("^case: has no field shape, of two bodies", lambda: plumb.bodies_of({"bodies": [{}, {}]})),
            ("^answer: holds NaN", lambda: plumb.check(ball, ball, {"overlap": np.nan})),
            ("^case: format: missing", lambda: plumb.shrink({})),
            ("^paths: must be one", lambda: plumb.replay([])),
            ("^solver: nowhere.so: ", lambda: plumb.campaign("spheroid", 1, solver="nowhere.so")),
            ("^threads: ", lambda: plumb.scene(plumb.named_scene("impact"), threads=0)),
            ("^accuracy: ", lambda: plumb.scene(plumb.named_scene("impact"), accuracy=3)),
            ("^bodies: ", lambda: plumb.named_scene("dice", -1)),
        ):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                call()

    def test_arguments_of_another_type(self):
        ball = plumb.Body((1, 1, 1), (0, 0, 0))
        for text, call in (
            ("answer: must be a dict, not int", lambda: plumb.check(ball, ball, 3)),
            ("answer: JSON has no set", lambda: plumb.check(ball, ball, {"x_a": {1}})),
            ("body2: must be a plumb.Body, not int", lambda: plumb.check(ball, 3, {})),
            ("body1: must be a plumb.Body, not str", lambda: plumb.certify("ball", ball)),
            ("pairs: must be (body1, body2) of each, not Body", lambda: plumb.certify_all(ball)),
            ("pairs[1]: must be (body1, body2)", lambda: plumb.certify_all([(ball, ball), (ball,)])),
            ("pairs[0]: must be two plumb.Body, not int", lambda: plumb.certify_all([(ball, 1)])),
            ("case: must be a dict, not str", lambda: plumb.shrink("case.json")),
            ("paths: must be a path, not int", lambda: plumb.replay([3])),
            ("paths: must be a path, not int", lambda: plumb.replay(3)),
            ("scene: must be a path, not int", lambda: plumb.scene(3)),
            ("scene: JSON has no set", lambda: plumb.scene_plan({"name": set()})),
            ("name: must be a text, not int", lambda: plumb.named_scene(3)),
        ):
            with self.subTest(text), self.assertRaises(TypeError) as raised:
                call()
            self.assertEqual(str(raised.exception), text)


def child_of(process):
    """The process that it started, or None."""
    children = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()
    return int(children[0]) if children else None


def catches_interrupts(process):
    """Its handler is in place: it keeps what is done."""
    status = pathlib.Path(f"/proc/{process}/status").read_text()
    caught = next(line for line in status.splitlines() if line.startswith("SigCgt"))
    return int(caught.split()[1], 16) >> (signal.SIGINT - 1) & 1 == 1


def has_judged(process):
    """It has been busy for a while; s."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return int(fields[11]) / os.sysconf("SC_CLK_TCK") > 0.3


def run_of(code):
    return subprocess.Popen(
        [sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def wait_until(process, ready):
    """False when it ended first."""
    while process.poll() is None:
        if ready():
            return True
        time.sleep(0.005)
    return False


class Interrupts(unittest.TestCase):
    def test_reach_the_program_once(self):
        with tempfile.TemporaryDirectory() as out:
            code = f"import plumb\nplumb.campaign('ellipsoid', 10**6, method='auto', out={out!r})"
            process = run_of(code)

            def ready():
                program = child_of(process.pid)
                return program is not None and catches_interrupts(program) and has_judged(program)

            self.assertTrue(wait_until(process, ready), "ended by itself")
            program = child_of(process.pid)
            process.send_signal(signal.SIGINT)
            said = process.communicate()[1]
            self.assertIn("KeyboardInterrupt", said)
            self.assertFalse(pathlib.Path(f"/proc/{program}").exists())
            summary = json.loads(pathlib.Path(out, "summary.json").read_text())
            self.assertTrue(0 < summary["cases"] < 10**6)

    def test_end_a_batch(self):
        size = 10**7
        bodies = plumb.Bodies(np.broadcast_to(np.ones(3), (size, 3)), (0, 0, 0), exponents=(3, 3))  # ten seconds of them
        out = plumb.Contacts(np.full(size, -1, np.int32), np.full(size, -1, np.int32))

        def interrupt_when_begun():
            while out.status[0] < 0:
                time.sleep(0.001)
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=interrupt_when_begun).start()
        with self.assertRaises(KeyboardInterrupt):
            plumb.solve_batch(bodies, plumb.Bodies((1, 1, 2), (0, 1.5, 0)), out=out, threads=2)
        self.assertEqual(out.status[-1], -1)


class FindingTheProgram(unittest.TestCase):
    def test_beside_the_package(self):
        folder = pathlib.Path(plumb.__file__).absolute().parent
        self.assertIn(plumb.find_program().parent, (folder / "bin", folder.parents[1] / "bin", folder.parents[3] / "bin"))

    def test_as_a_module(self):
        command = [sys.executable, "-B", "-m", "plumb", "--version"]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        self.assertEqual(said, f"plumb {plumb.__version__}\n")

    def test_in_the_path_or_nowhere(self):
        code = "import plumb._program as p; p._PACKAGE = p.Path('/nowhere/a/b/c/d'); print(p.find_program())"
        path = str(plumb.find_program().parent)
        for value, expected in ((path, f"{path}/plumb\n"), ("/nowhere", "FileNotFoundError: no program 'plumb' in /nowhere")):
            said = subprocess.run(
                [sys.executable, "-B", "-c", code], capture_output=True, text=True, env={**os.environ, "PATH": value}
            )
            self.assertIn(expected, said.stdout + said.stderr)


if __name__ == "__main__":
    unittest.main()
