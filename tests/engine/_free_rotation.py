"""Torque-free rotation of an asymmetric rigid body: Jacobi's solution (Landau and Lifshitz, Mechanics,
section 37), with I1 < I2 < I3 and L^2 > 2 E I2."""

import math

import numpy as np


def jacobi(u, k):
    """sn, cn, dn of argument u, modulus k, by descending Landen transformation (Abramowitz and Stegun,
    16.4: arithmetic-geometric mean)."""
    a, b, c = [1.0], [math.sqrt(1.0 - k * k)], [k]
    while abs(c[-1]) > 1e-15:
        a_last, b_last = a[-1], b[-1]
        a.append(0.5 * (a_last + b_last))
        b.append(math.sqrt(a_last * b_last))
        c.append(0.5 * (a_last - b_last))
    phi = 2.0 ** (len(a) - 1) * a[-1] * u
    for n in range(len(a) - 1, 0, -1):
        phi = 0.5 * (phi + np.arcsin(c[n] * np.sin(phi) / a[n]))
    sine = np.sin(phi)
    return sine, np.cos(phi), np.sqrt(1.0 - (k * sine) ** 2)


class FreeBody:
    """Body with principal moments (3,), kg m2, that starts with the angular velocity
    (w1, 0, w3), rad/s, in its own frame."""

    def __init__(self, moments, w1, w3):
        i1, i2, i3 = self.moments = np.asarray(moments, float)
        energy2 = i1 * w1 ** 2 + i3 * w3 ** 2  # 2 E
        square = (i1 * w1) ** 2 + (i3 * w3) ** 2  # L^2
        assert i1 < i2 < i3 and square > energy2 * i2
        self.momentum = math.sqrt(square)
        self.amplitudes = np.sqrt([(energy2 * i3 - square) / (i1 * (i3 - i1)),
                                   (energy2 * i3 - square) / (i2 * (i3 - i2)),
                                   (square - energy2 * i1) / (i3 * (i3 - i1))])
        self.rate = math.sqrt((i3 - i2) * (square - energy2 * i1) / (i1 * i2 * i3))
        self.modulus = math.sqrt((i2 - i1) * (energy2 * i3 - square)
                                 / ((i3 - i2) * (square - energy2 * i1)))

    def omega(self, t):
        """Angular velocity in the body frame (3,) or (3, T), rad/s."""
        sn, cn, dn = jacobi(self.rate * t, self.modulus)
        return np.array([self.amplitudes[0] * cn, self.amplitudes[1] * sn, self.amplitudes[2] * dn])

    def _precession_rate(self, t):
        i1, i2, _ = self.moments
        w1, w2, _ = self.omega(t)
        return self.momentum * (i1 * w1 ** 2 + i2 * w2 ** 2) / ((i1 * w1) ** 2 + (i2 * w2) ** 2)

    def precession(self, t, pieces=400):
        """Angle about the angular momentum (rad): quadrature of the closed form, to rounding."""
        nodes, weights = np.polynomial.legendre.leggauss(12)
        edges = np.linspace(0.0, t, pieces + 1)
        half = 0.5 * np.diff(edges)[:, None]
        times = 0.5 * (edges[1:] + edges[:-1])[:, None] + half * nodes
        return float((half * weights * self._precession_rate(times)).sum())

    def rotation(self, t):
        """Body to space (3, 3), where the space z axis is along the angular momentum."""
        i1, i2, i3 = self.moments
        w1, w2, w3 = self.omega(t)
        theta = math.acos(i3 * w3 / self.momentum)
        psi = math.atan2(i1 * w1, i2 * w2)
        return turn_z(self.precession(t)) @ turn_x(theta) @ turn_z(psi)


def turn_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def turn_x(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
