"""What has no closed form: the law's equations, integrated in steps so short that halving them moves the result by less than 3e-5 of it."""

import math

import numpy as np


def stepped(rates, state, step):
    """A step of the fourth order (Runge and Kutta) of state' = rates(state), a sequence of numbers."""
    def moved(by, step):
        return [x + step * dx for x, dx in zip(state, by)]

    a = rates(state)
    b = rates(moved(a, step / 2))
    c = rates(moved(b, step / 2))
    d = rates(moved(c, step))
    return [x + step / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(state, a, b, c, d)]


def oblique(factor, mass, radius, normal, across, restitution, friction, ratio=2 / 7, steps=40000):
    """A ball that meets a plane, elastic force factor overlap^(3/2): velocity across and spin afterwards.

    overlap'' = -(N + c overlap') / m, N = factor overlap^(3/2), k = 3/2 factor overlap^(1/2), c = 2 beta sqrt(5/6 k m)
    pull'     = -ratio k (velocity of the point of contact, whose lever is radius - overlap/2), and while k falls pull k'/k; at most friction N
    """
    log = math.log(restitution)
    beta = -log / math.hypot(math.pi, log)
    inertia = 0.4 * mass * radius ** 2

    def rates(state):
        overlap, closing, v, spin, pull = state
        overlap = max(overlap, 0.0)
        k = 1.5 * factor * math.sqrt(overlap)
        push = factor * overlap ** 1.5 + 2 * beta * math.sqrt(5 / 6 * k * mass) * closing
        lever = radius - overlap / 2
        falls = pull * closing / (2 * overlap) if closing < 0 < overlap else 0.0
        return closing, -push / mass, pull / mass, -lever * pull / inertia, -ratio * k * (v - lever * spin) + falls

    step = 3.2 * (mass ** 2 / (factor ** 2 * normal)) ** 0.2 / steps  # of about as many in the collision
    state = [0.0, normal, across, 0.0, 0.0]
    while True:
        state = stepped(rates, state, step)
        if state[0] <= 0:
            return state[2], state[3]
        most = friction * factor * state[0] ** 1.5
        state[4] = max(-most, min(most, state[4]))


def viscoelastic(factor, mass, radius, speed, rate, steps=40000):
    """The restitution of a ball on a plane: overlap'' = -factor overlap^(3/2) / mass - rate sqrt(radius overlap) overlap'."""
    def rates(state):
        overlap, closing = max(state[0], 0.0), state[1]
        return closing, -factor * overlap ** 1.5 / mass - rate * math.sqrt(radius * overlap) * closing

    step = 3.2 * (mass ** 2 / (factor ** 2 * speed)) ** 0.2 / steps
    state = [0.0, speed]
    while True:
        state = stepped(rates, state, step)
        if state[0] <= 0:
            return -state[1] / speed


def frictional(mobility, approach, normal, restitution, friction, ratio=2 / 7, steps=2000):
    """The impulse on the first of two bodies that meet and hardly turn meanwhile. mobility: 3 x 3, both bodies' in sum; approach: the velocity of the
    first's point against the second's; normal: unit, from the first to the second.

    overlap'  = velocity . normal
    spring'   = velocity across the normal, and as long as friction overlap / ratio at most
    velocity' = mobility force, force = -(overlap + c overlap') normal - ratio spring, c = 2 beta sqrt(mass)
    The stiffness is 1: no impulse depends on it.
    """
    mass = 1 / (normal @ mobility @ normal)
    log = math.log(restitution)
    damping = -2 * log / math.hypot(math.pi, log) * math.sqrt(mass)

    def cut(spring, overlap):
        length, most = np.linalg.norm(spring), friction * max(overlap, 0.0) / ratio
        return spring * (most / length) if length > most else spring

    def rates(state):
        overlap, spring, velocity = state[0], cut(np.array(state[1:4]), state[0]), np.array(state[4:7])
        closing = velocity @ normal
        force = -(overlap + damping * closing) * normal - ratio * spring
        return np.concatenate(([closing], velocity - closing * normal, mobility @ force, force))

    state = np.concatenate((np.zeros(4), approach, np.zeros(3)))
    step = math.pi * math.sqrt(mass) / steps
    while True:
        after = np.array(stepped(rates, state, step))
        if after[0] <= 0:
            part = state[0] / (state[0] - after[0])
            return (state + part * (after - state))[7:]
        after[1:4] = cut(after[1:4], after[0])
        state = after


def rocking(semi_axes, power, mass, moment, stiffness, gravity, first, duration, steps=800000):
    """(height, angle, spin) at the end of what is at first (height, angle) and at rest on ice, and turns about its second axis.

    h(angle) = ((a sin)^q + (c cos)^q)^(1/q): how far it reaches along the vertical, q the power
    height'' = N / mass - gravity, angle'' = -N h' / moment, N = stiffness (h - height)
    """
    a, c = semi_axes[0], semi_axes[2]

    def rates(state):
        height, angle, rise, spin = state
        along, up = abs(a * math.sin(angle)), c * math.cos(angle)
        total = along ** power + up ** power
        reach = total ** (1 / power)
        slope = (along ** (power - 1) * math.copysign(a * math.cos(angle), angle) - up ** (power - 1) * c * math.sin(angle)) * reach / total
        push = stiffness * max(reach - height, 0.0)
        return rise, spin, push / mass - gravity, -push * slope / moment

    step, state = duration / steps, (*first, 0.0, 0.0)
    for _ in range(steps):
        state = stepped(rates, state, step)
    return state[0], state[1], state[3]
