"""A foreign program that does what its first argument says, and is a solver otherwise: the overlap is body 2's x, and nothing else."""

import ctypes
import json
import os
import signal
import subprocess
import sys
import time

HOW, REST = sys.argv[1], sys.argv[2:]
kept = []


def say(text):
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def spin():
    while True:
        pass


def note(*processes):
    """For the test to see that they are gone."""
    with open(REST[0] + ".new", "w") as file:
        file.write(" ".join(map(str, processes)))
    os.rename(REST[0] + ".new", REST[0])


def leave_behind():
    """A process that has left this one's group and session, and goes on."""
    other = subprocess.Popen([sys.executable, "-c", "while True: pass"], start_new_session=True)
    note(os.getpid(), other.pid)
    spin()


def refuse_to_die():
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    sys.stdin.close()
    note(os.getpid())
    while True:
        time.sleep(1)


def kill_host():
    for target in (os.getppid(), -os.getpgid(os.getppid()), -1):
        try:
            os.kill(target, signal.SIGKILL)
        except PermissionError:
            continue
        os._exit(9)


def first_line():
    if HOW == "exit_at_once":
        sys.exit("no licence found")
    if HOW == "hang_at_once":
        spin()
    return {
        "chatty_start": "Welcome to solver 3",
        "bad_abilities": '{"shapes": "potatoes"}',
        "nameless": "{}",
        "warm": '{"name": "mine", "warm": true}',
    }.get(HOW, '{"name": "mine", "version": "1.2", "licence": "MIT", "shapes": "ellipsoids", "tolerance": 1e-6}')


def reply(request):
    number = request["number"]
    right = {"number": number, "overlap": request["bodies"][1]["position"][0]}
    replies = {
        "noise": "debug: %d bodies" % len(request["bodies"]),
        "other_number": json.dumps({**right, "number": number + 1}),
        "no_number": '{"overlap": 1}',
        "nan": '{"number": %d, "overlap": NaN}' % number,
        "broken": '{"number": %d, "overlap"' % number,
        "beyond": '{"number": %d, "overlap": 1e999}' % number,
        "word": json.dumps({**right, "status": "fine"}),
        "short": json.dumps({**right, "normal": [1, 0]}),
        "unknown": json.dumps({**right, "depth": 1}),
        "nothing": json.dumps({"number": number}),
        "refuse": json.dumps({"number": number, "refused": True}),
        "huge_line": "x" * (3 << 20),
        "time": json.dumps({**right, "ns": 1234.5}),
        "warm": json.dumps({**right, "overlap": request.get("last", {}).get("overlap", 0) + 1}),
        "cold": json.dumps({**right, "overlap": 1 if "last" in request else 0}),
        "format": json.dumps({**right, "overlap": 1 if request["format"] == "plumb/solve-1" else 0}),
    }
    return replies.get(HOW, json.dumps(right))


def misbehave():
    if HOW == "crash":
        sys.stderr.write("before\nout of 0x1234 ideas\n")
        sys.stderr.flush()
        ctypes.string_at(0)
    elif HOW == "raise":
        raise ValueError("no such shape")
    elif HOW == "exit":
        os._exit(0)
    elif HOW == "hang":
        note(os.getpid()) if REST else None
        spin()
    elif HOW == "sleep":
        time.sleep(1000)
    elif HOW == "leave_behind":
        leave_behind()
    elif HOW == "refuse_to_die":
        refuse_to_die()
    elif HOW == "busy_child":
        subprocess.run([sys.executable, "-c", "while True: pass"])
    elif HOW == "close":
        os.close(1)
        time.sleep(1000)
    elif HOW == "hog":
        kept.append(b"x" * (1 << 29))
        spin()
    elif HOW == "leak":
        kept.append(b"x" * 65536)
    elif HOW == "talk":
        sys.stderr.write("a solver that talks, and talks\n" * 20000)
    elif HOW == "kill_host":
        kill_host()
    elif HOW == "orphans":
        subprocess.run(["sh", "-c", "true &"])
    elif HOW == "fork" and os.fork() == 0:
        time.sleep(1000)


say(first_line())
if HOW == "deaf":
    for n in range(1, 1000):
        say('{"number": %d, "overlap": 1}' % n)
    time.sleep(1000)
for line in sys.stdin:
    misbehave()
    say(reply(json.loads(line)))
