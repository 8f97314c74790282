"""What has no closed form: the law's equations, integrated in steps so short that halving them moves the result by less than 3e-5."""

import math


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

    def moved(state, by, step):
        return [x + step * dx for x, dx in zip(state, by)]

    step = 3.2 * (mass ** 2 / (factor ** 2 * normal)) ** 0.2 / steps  # of about as many in the collision
    state = [0.0, normal, across, 0.0, 0.0]
    while True:
        a = rates(state)
        b = rates(moved(state, a, step / 2))
        c = rates(moved(state, b, step / 2))
        d = rates(moved(state, c, step))
        state = [x + step / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(state, a, b, c, d)]
        if state[0] <= 0:
            return state[2], state[3]
        most = friction * factor * state[0] ** 1.5
        state[4] = max(-most, min(most, state[4]))
