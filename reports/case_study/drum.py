"""The scene of the case study: superquadrics in a drum that turns, as plumb/scene-1."""

import math
import random

SEMI_AXES = (0.0045, 0.004, 0.0032)  # m, each drawn within a tenth
EXPONENTS = (2.5, 4.0)               # drawn between them
DENSITY = 2500.0                     # kg/m^3
FILLED = 0.4                         # of the drum's volume, as the bodies are stacked
TURNING = 3.0                        # rad/s about the y axis
LENGTH_OVER_RADIUS = 1.25
GAP = 1.04                           # of the stack, over the greatest bodies
FRAMES_A_SECOND = 50


def body(axes, exponents, place, quaternion, velocity, spin):
    return {"shape": {"superellipsoid": {"semi_axes": list(axes), "exponents": list(exponents)}}, "position": list(place),
            "orientation": {"quaternion_wxyz": list(quaternion)}, "density": DENSITY, "velocity": list(velocity), "angular_velocity": list(spin)}


def drawn(draw, place):
    """Along the axes, so that a stack has no overlaps; it moves a little, so that the stack does not last."""
    axes = [axis * draw.uniform(0.9, 1.1) for axis in SEMI_AXES]
    exponents = [draw.uniform(*EXPONENTS) for _ in range(2)]
    velocity = [draw.uniform(-0.1, 0.1) for _ in range(3)]
    return body(axes, exponents, place, (1, 0, 0, 0), velocity, [draw.uniform(-5, 5) for _ in range(3)])


def drum(bodies):
    """Radius and half a length that the bodies fill as they should."""
    cell = math.prod(2.2 * GAP * axis for axis in SEMI_AXES)
    radius = (bodies * cell / FILLED / (math.pi * LENGTH_OVER_RADIUS)) ** (1 / 3)
    return radius, radius * LENGTH_OVER_RADIUS / 2


def stacked(bodies, radius, half_length):
    """Places of a stack from the drum's lowest line up; whole bodies within the drum."""
    x, y, z = (2.2 * GAP * axis for axis in SEMI_AXES)
    across, along = int(half_length / y - 0.5), int(radius / x)
    height, left = -radius, bodies
    while True:
        height += z
        for i in range(-along, along + 1):
            if math.hypot(abs(i) * x + x / 2, abs(height) + z / 2) >= radius:
                continue
            for j in range(-across, across + 1):
                if left == 0:
                    return
                left -= 1
                yield i * x, j * y, height


def of_bodies(bodies, duration, outputs):
    """The scene that holds them."""
    radius, half_length = drum(len(bodies))
    quarter = math.sqrt(0.5)
    wall = {"position": [0, 0, 0], "orientation": {"quaternion_wxyz": [quarter, -quarter, 0, 0]},
            "cylinder": {"radius": radius, "half_length": half_length, "side": "inside", "ends": "closed"}}
    effects = {"gravity": {"acceleration": [0, 0, -9.81]}, "linear": {"stiffness": 1000}, "damping": {"restitution": 0.3},
               "friction": {"coefficient": 0.5}, "moving_walls": {"motions": [{"wall": 0, "angular_velocity": [0, TURNING, 0]}]}}
    run = {"time_step": "auto", "duration": duration, "accuracy": 1e-2, "outputs": outputs}
    return {"format": "plumb/scene-1", "name": "drum", "bodies": bodies, "walls": [wall], "effects": effects, "run": run}


def scene(bodies, duration, seed=1):
    """So many, stacked."""
    draw = random.Random(seed)
    return of_bodies([drawn(draw, place) for place in stacked(bodies, *drum(bodies))], duration, {"every": 1 / FRAMES_A_SECOND, "write": ["dump"]})
