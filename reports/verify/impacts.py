"""Impacts of balls: along the normal by each elastic law, and oblique ones.

Data of Chung & Ooi's tests 2 to 4 are those of YADE's scripts after them (examples/test-DEM), where the plane is 1000 times as stiff; here it is
rigid, as the paper says."""

import math

import exact
import ode
import rigid
from case import CHUNG, Case
from scenes import ball, body, floor, momentum, scene, velocity

YADE = CHUNG + ", data as in YADE's scripts"
GLASS = {"E": 4.8e10, "nu": 0.20, "rho": 2800}
LIMESTONE = {"E": 2.0e10, "nu": 0.25, "rho": 2500}
ALUMINIUM = {"E": 7.0e10, "nu": 0.30, "rho": 2699}
MAGNESIUM = {"E": 4.0e10, "nu": 0.35, "rho": 1800}
OXIDE = {"E": 3.8e11, "nu": 0.23, "rho": 4000}
ALLOY = {"E": 7.0e10, "nu": 0.33, "rho": 2700}
IRON = {"E": 1.0e11, "nu": 0.25, "rho": 7000}


def hertz(material):
    return {"youngs_modulus": material["E"], "poissons_ratio": material["nu"]}


def life(ran):
    one = ran.only_life()
    return {"overlap": one["greatest_overlap"], "force": one["greatest_force"], "duration": one["duration"]}


def of(collision):
    return {"overlap": collision.overlap, "force": collision.force, "duration": collision.duration}


def before(collision, speed):
    """How far apart what meets at a speed begins, and how long the run lasts."""
    gap = float(collision.overlap) / 3
    return gap, gap / speed + 1.3 * float(collision.duration)


def two_balls(name, material):
    """Chung & Ooi's first: radius 10 mm, each at 10 m/s."""
    radius, speed = 0.01, 20.0
    mass = exact.ball_mass(radius, material["rho"])
    factor = exact.hertz_ball(exact.modulus(material["E"], material["nu"]), radius / 2)
    collision = exact.Collision(factor, mass / 2, speed)
    gap, lasts = before(collision, speed)
    at = radius + gap / 2
    bodies = [ball(radius, (-at, 0, 0), (speed / 2, 0, 0), density=material["rho"]),
              ball(radius, (at, 0, 0), (-speed / 2, 0, 0), density=material["rho"])]
    return Case(f"two-{name}", f"1: two balls, {name}", CHUNG, scene(bodies, {"hertz": hertz(material)}, lasts), of(collision), life)


def on_rigid(material, radius, speed, angle_deg=0.0, restitution=1.0, friction=0.0):
    """A ball that meets a rigid plane: the collision and the scene."""
    mass = exact.ball_mass(radius, material["rho"])
    normal, across = speed * math.cos(math.radians(angle_deg)), speed * math.sin(math.radians(angle_deg))
    collision = exact.Collision(exact.hertz_ball(exact.modulus(material["E"], material["nu"], "rigid"), radius), mass, normal)
    gap, lasts = before(collision, normal)
    effects = {}
    if restitution < 1:
        effects["damping"] = {"restitution": restitution}
        lasts *= 2 / restitution
    if friction > 0:
        effects["friction"] = {"coefficient": friction}
    bodies = [ball(radius, (0, 0, radius + gap), (across, 0, -normal), density=material["rho"], material="ball")]
    materials = {"ball": {"hertz": hertz(material)}, "plane": {"rigid": True}}
    return collision, scene(bodies, effects, lasts, [floor(material="plane")], materials=materials)


def on_plane(name, material):
    collision, tree = on_rigid(material, 0.1, 0.2)
    return Case(f"plane-{name}", f"2: ball on a rigid plane, {name}", YADE, tree, of(collision), life)


def restitution(name, material, e):
    _, tree = on_rigid(material, 0.0025, 3.9, restitution=e)
    return Case(f"restitution-{name}-{e}", f"3: restitution, {name}", YADE, tree, {f"e = {e}": e},
                lambda ran: {f"e = {e}": velocity(ran.last)[2] / 3.9})


def spin_of(ran, radius, density):
    return momentum(ran.last)[1] / float(exact.ball_mass(radius, density) * radius ** 2 * 2 / 5)


def oblique(name, material, angle):
    """Gross sliding throughout: beyond 33 degrees for these numbers (tan = 7/2 mu (1 + e))."""
    radius, speed, mu, e = 0.0025, 3.9, 0.092, 0.98
    collision, tree = on_rigid(material, radius, speed, angle, e, mu)
    theta = math.radians(angle)
    spin = 2.5 * mu * (1 + e) * speed * math.cos(theta) / radius
    lever = 1 - collision.mean_overlap / 2 / radius
    return Case(f"oblique-{name}-{angle}", f"4: oblique at {angle} degrees, {name}", YADE, tree,
                {"e_t": 1 - mu * (1 + e) / math.tan(theta), "spin": spin, "spin, lever R - overlap/2": spin * lever},
                lambda ran: {"e_t": velocity(ran.last)[0] / (speed * math.sin(theta)),
                             "spin": spin_of(ran, radius, material["rho"]),
                             "spin, lever R - overlap/2": spin_of(ran, radius, material["rho"])})


def sticking(name, material, angle):
    """Below 33 degrees it sticks and slips."""
    radius, speed, mu, e = 0.0025, 3.9, 0.092, 0.98
    _, tree = on_rigid(material, radius, speed, angle, e, mu)
    theta = math.radians(angle)
    factor = exact.hertz_ball(exact.modulus(material["E"], material["nu"], "rigid"), radius)
    mass = float(exact.ball_mass(radius, material["rho"]))
    across, spin = ode.oblique(float(factor), mass, radius, speed * math.cos(theta), speed * math.sin(theta), e, mu)
    return Case(f"sticking-{name}-{angle}", f"4: oblique at {angle} degrees, {name}", "the law's ODE, " + YADE, tree,
                {"e_t": across / (speed * math.sin(theta)), "spin": spin},
                lambda ran: {"e_t": velocity(ran.last)[0] / (speed * math.sin(theta)), "spin": spin_of(ran, radius, material["rho"])})


def on_a_spring():
    """Two balls that meet, each at speed 1, by a linear force: the collision, the bodies, the effects and how long it takes."""
    speed, stiffness = 1.0, 1e9
    spring = exact.Spring(stiffness, exact.ball_mass(1, 1) / 2, 2 * speed)
    gap, lasts = before(spring, 2 * speed)
    bodies = [ball(1.0, (-1 - gap / 2, 0, 0), (speed, 0, 0)), ball(1.0, (1 + gap / 2, 0, 0), (-speed, 0, 0))]
    return spring, bodies, {"linear": {"stiffness": stiffness}}, lasts


def linear(restitution=1.0):
    spring, bodies, effects, lasts = on_a_spring()
    if restitution == 1:
        return Case("linear", "linear force, two balls", "Schwager & Poschel 2007", scene(bodies, effects, lasts), of(spring), life)
    effects["damping"] = {"restitution": restitution}
    return Case(f"linear-{restitution}", "linear force and dashpot", "Schwager & Poschel 2007", scene(bodies, effects, 2 * lasts),
                {f"e = {restitution}": restitution}, lambda ran: {f"e = {restitution}": velocity(ran.last, 1)[0]})


def by_mass(share):
    """Two balls and a dashpot by their mass: so much of the frequency a unit of time."""
    spring, bodies, effects, lasts = on_a_spring()
    rate = share * float(exact.pi / spring.duration)
    effects["damping"] = {"restitution": 1, "mass_velocity": rate}
    name = f"e, mass_velocity {share} of the frequency"
    return Case(f"by-mass-{share}", "linear force, dashpot by mass", "Schwager & Poschel 2007", scene(bodies, effects, 3 * lasts),
                {name: exact.damped(rate / 2, exact.pi / spring.duration)}, lambda ran: {name: velocity(ran.last, 1)[0]})


def viscoelastic(share):
    """A ball on a rigid plane and a dashpot by the contact's radius."""
    radius, speed = 0.0025, 3.9
    collision, tree = on_rigid(OXIDE, radius, speed)
    rate = share / float(collision.duration) / math.sqrt(radius * float(collision.overlap))
    tree["effects"]["damping"] = {"restitution": 1, "viscoelastic": rate}
    tree["run"]["duration"] *= 3
    factor, mass = float(exact.hertz_ball(exact.modulus(OXIDE["E"], OXIDE["nu"], "rigid"), radius)), float(exact.ball_mass(radius, OXIDE["rho"]))
    name = f"e, viscoelastic {share}"
    return Case(f"viscoelastic-{share}", "Hertz, dashpot by the contact's radius", "the law's ODE, Brilliantov et al. 1996", tree,
                {name: ode.viscoelastic(factor, mass, radius, speed, rate)}, lambda ran: {name: velocity(ran.last)[2] / speed})


def stuck(ratio, has_own_stiffness=False):
    """A ball that does not slide: a spring across the normal, so much of the normal one; by a stiffness of its own."""
    speed, stiffness = 1.0, 1e12
    spring = exact.Spring(stiffness, exact.ball_mass(1, 1), speed)
    gap, lasts = before(spring, speed)
    friction = {"stiffness": ratio * stiffness} if has_own_stiffness else {"stiffness_ratio": ratio}
    effects = {"linear": {"stiffness": stiffness}, "friction": {"coefficient": 100, **friction}}
    tree = scene([ball(1, (0, 0, 1 + gap), (1, 0, -speed))], effects, lasts, [floor()])
    name, kind = f"v_t, ratio {ratio:.3g}", "stiffness" if has_own_stiffness else "ratio"
    return Case(f"stuck-{kind}-{ratio:.3g}", f"oblique, sticks, by {kind}", "two springs, closed form", tree, {name: exact.stuck(ratio)},
                lambda ran: {name: velocity(ran.last)[0]})


def ellipsoid_head_on():
    """An elliptic patch: an ellipsoid that meets a plane with its shortest axis, and does not turn."""
    axes, speed, young, nu = (1.0, 0.8, 0.6), 1e-2, 1e6, 0.3
    mass, _ = rigid.mass_and_moments(axes, (2, 2))
    factor = exact.hertz_ellipse(exact.modulus(young, nu), axes[0] ** 2 / axes[2], axes[1] ** 2 / axes[2])
    collision = exact.Collision(factor, mass, speed)
    gap, lasts = before(collision, speed)
    effects = {"hertz": {"youngs_modulus": young, "poissons_ratio": nu}}
    tree = scene([body(axes, (2, 2), (0, 0, axes[2] + gap), (0, 0, -speed))], effects, lasts, [floor()])
    return Case("elliptic", "Hertz, elliptic patch, on a plane", "Johnson 1985, 4.24-4.28", tree, of(collision), life)


def by_volume(name, effects, overlap, force):
    radius, speed = 1.0, 1.0
    duration = 4 * float(overlap) / speed
    gap = float(overlap) / 3
    tree = scene([ball(radius, (0, 0, radius + gap), (0, 0, -speed))], effects, duration, [floor()])
    return Case(name, f"{name}, ball on a plane", "energy of the cap's volume", tree, {"overlap": overlap, "force": force},
                lambda ran: {key: life(ran)[key] for key in ("overlap", "force")})


def volumes():
    energy = exact.ball_mass(1, 1) / 2
    stiffness, exponent = 1e6, 1.5
    d = exact.volume_overlap(stiffness, exponent, 1, energy)
    area = exact.pi * (2 * d - d ** 2)
    yield by_volume("volume", {"volume": {"stiffness": stiffness, "exponent": exponent}}, d,
                    stiffness * exponent * exact.cap_volume(1, d) ** (exact.mpf(exponent) - 1) * area)
    d = exact.foundation_overlap(stiffness, 1, energy)
    yield by_volume("foundation", {"foundation": {"stiffness": stiffness}}, d, stiffness * exact.cap_volume(1, d))


def cases():
    yield two_balls("glass", GLASS)
    yield two_balls("limestone", LIMESTONE)
    yield on_plane("aluminium", ALUMINIUM)
    yield on_plane("magnesium", MAGNESIUM)
    for e in (0.2, 0.4, 0.6, 0.8, 1.0):
        yield restitution("aluminium oxide", OXIDE, e)
        yield restitution("cast iron", IRON, e)
    for angle in (5, 15, 25):
        yield sticking("aluminium oxide", OXIDE, angle)
        yield sticking("aluminium alloy", ALLOY, angle)
    for angle in (45, 60, 75):
        yield oblique("aluminium oxide", OXIDE, angle)
        yield oblique("aluminium alloy", ALLOY, angle)
    yield linear()
    yield linear(0.5)
    yield ellipsoid_head_on()
    yield from volumes()
    yield by_mass(0.5)
    yield viscoelastic(0.5)
    yield stuck(0.1)
    yield stuck(2 / 7)
    yield stuck(0.1, has_own_stiffness=True)
