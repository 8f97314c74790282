"""Closed forms, in 30 digits, with nothing of plumb's: the sources stand at each."""

from mpmath import beta, cos, ellipe, ellipf, ellipfun, ellipk, exp, findroot, gamma, mp, mpf, pi, quad, sqrt

mp.dps = 30


def modulus(young, poisson, other=None):
    """E* of two of one material, or with a rigid one (Johnson 1985, eq. 4.23)."""
    compliance = (1 - mpf(poisson) ** 2) / mpf(young)
    return 1 / (2 * compliance if other is None else compliance)


def ball_mass(radius, density):
    return 4 * pi / 3 * mpf(radius) ** 3 * mpf(density)


class Collision:
    """Elastic, force = factor overlap^(3/2), reduced mass, at a speed (Johnson 1985, eqs. 11.23-11.24)."""

    def __init__(self, factor, mass, speed):
        self.overlap = (5 * mass * mpf(speed) ** 2 / (4 * factor)) ** mpf("0.4")
        self.force = factor * self.overlap ** mpf("1.5")
        self.duration = mpf("0.8") * sqrt(pi) * gamma(mpf("0.4")) / gamma(mpf("0.9")) * self.overlap / speed
        # int N overlap dt / int N dt, N = factor overlap^(3/2)
        self.mean_overlap = self.overlap * beta(mpf("1.4"), mpf("0.5")) / beta(1, mpf("0.5"))


def hertz_ball(e_star, radius):
    return mpf(4) / 3 * e_star * sqrt(mpf(radius))


def hertz_ellipse(e_star, radius1, radius2):
    """Factor of overlap^(3/2) for relative principal radii (Johnson 1985, eqs. 4.24-4.28): with the patch's semi-axes ratio r = b/a and e^2 = 1 - r^2,
    radius1/radius2 = (E/r^2 - K)/(K - E) fixes r, and overlap = 3 F K / (2 pi a E*), a^3 = 3 F R1 (K - E) / (pi e^2 E*) for 1/R1 = 2 A."""
    larger, smaller = max(mpf(radius1), mpf(radius2)), min(mpf(radius1), mpf(radius2))
    a, b = 1 / (2 * larger), 1 / (2 * smaller)

    def parts(ratio):
        m = 1 - ratio ** 2
        return ellipk(m), ellipe(m), m

    def excess(ratio):
        k, e, _ = parts(ratio)
        return (e / ratio ** 2 - k) / (k - e) - b / a

    ratio = findroot(excess, (a / b) ** (mpf(2) / 3))
    k, e, m = parts(ratio)
    # A = 3 F (K - E) / (2 pi e^2 a^3 E*), overlap = 3 F K / (2 pi a E*)
    axis = (3 * (k - e) / (2 * pi * m * a * e_star)) ** (mpf(1) / 3)  # a = axis F^(1/3)
    return (3 * k / (2 * pi * axis * e_star)) ** mpf("-1.5")


class Neck:
    """JKR's contact of a ball of radius R and work of adhesion w (Johnson, Kendall & Roberts 1971), by the radius a of its patch: overlap =
    a^2/R - sqrt(2 pi w a/E*), force = 4 E* a^3/(3 R) - sqrt(8 pi w E* a^3). It begins at overlap 0 and ends where the overlap is least;
    `lost` is what the force has done on the way in from there to the way out."""

    def __init__(self, work, e_star, radius):
        w, r = mpf(work), mpf(radius)

        def overlap(a):
            return a ** 2 / r - sqrt(2 * pi * w * a / e_star)

        def force(a):
            return 4 * e_star * a ** 3 / (3 * r) - sqrt(8 * pi * w * e_star * a ** 3)

        def slope(a):
            return 2 * a / r - sqrt(pi * w / (2 * e_star * a))

        scale = (pi * w * r ** 2 / e_star) ** (mpf(1) / 3)
        begins = findroot(overlap, 1.3 * scale)
        ends = findroot(slope, scale / 2)
        self.lost = -quad(lambda a: force(a) * slope(a), [ends, begins])
        self.rest = overlap(findroot(force, 1.5 * scale))


class Spring:
    """Collision with a linear force."""

    def __init__(self, stiffness, mass, speed):
        rate = sqrt(mpf(stiffness) / mass)
        self.overlap = mpf(speed) / rate
        self.force = stiffness * self.overlap
        self.duration = pi / rate


def damped(half_rate, frequency):
    """The restitution of x'' + 2 half_rate x' + frequency^2 x = 0, back at x = 0."""
    return exp(-pi * half_rate / sqrt(mpf(frequency) ** 2 - mpf(half_rate) ** 2))


def stuck(ratio):
    """Tangential velocity of the centre after / before, of a ball that sticks in a linear collision, friction spring = ratio * the normal's: the
    point of contact, whose mass is 2/7, swings by pi sqrt(7/2 ratio)."""
    return 1 - mpf(2) / 7 * (1 - cos(pi * sqrt(mpf(7) / 2 * mpf(ratio))))


def cap_volume(radius, overlap):
    return pi * overlap ** 2 * (radius - overlap / 3)


def volume_overlap(stiffness, exponent, radius, energy):
    """Where stiffness V^exponent has taken up the energy."""
    volume = (energy / stiffness) ** (1 / mpf(exponent))
    return findroot(lambda d: cap_volume(radius, d) - volume, sqrt(volume / (pi * radius)))


def foundation_overlap(stiffness, radius, energy):
    """The same of int stiffness V."""
    return findroot(lambda d: stiffness * pi * (radius * d ** 3 / 3 - d ** 4 / 12) - energy,
                    (3 * energy / (stiffness * pi * radius)) ** (mpf(1) / 3))


class Tumbling:
    """A free body of moments I1 < I2 < I3 that starts with w = (w1, 0, w3), L^2 > 2 T I2 (Landau & Lifshitz, Mechanics, section 37)."""

    def __init__(self, moments, w1, w3):
        i1, i2, i3 = (mpf(i) for i in moments)
        self.moments, w1, w3 = (i1, i2, i3), mpf(w1), mpf(w3)
        twice, square = i1 * w1 ** 2 + i3 * w3 ** 2, (i1 * w1) ** 2 + (i3 * w3) ** 2
        assert square > twice * i2
        self.momentum = sqrt(square)
        self.rate = sqrt((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3))
        self.m = (i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1))
        self.w1, self.w3 = w1, w3
        self.w2 = sqrt((twice * i3 - square) / (i2 * (i3 - i2)))
        self.period = 4 * ellipk(self.m) / self.rate

    def spin(self, time):
        u = self.rate * mpf(time)
        return (self.w1 * ellipfun("cn", u, m=self.m), self.w2 * ellipfun("sn", u, m=self.m),
                self.w3 * ellipfun("dn", u, m=self.m))

    def precession(self, time):
        """Angle by which the body's third axis has turned about the momentum."""
        i1, i2, _ = self.moments

        def rate(t):
            w1, w2, _ = self.spin(t)
            return self.momentum * (i1 * w1 ** 2 + i2 * w2 ** 2) / ((i1 * w1) ** 2 + (i2 * w2) ** 2)

        return quad(rate, [mpf(time) * k / 16 for k in range(17)])
