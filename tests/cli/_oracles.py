# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Geometry of bodies written again with numpy, as an oracle: nothing here is the tools' code."""
import itertools

import numpy as np


def rotation(q):
    """Matrix of the unit quaternion (w, x, y, z), from the body to space."""
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def contact_function(r, a, b):
    """max over s of s (1 - s) r ((1 - s) a + s b)^-1 r: below 1 where the ellipsoids overlap."""
    s = np.linspace(0, 1, 41)[1:-1]

    def value(s):
        m = (1 - s)[:, None, None] * a + s[:, None, None] * b
        return s * (1 - s) * np.einsum("i,nij,j->n", r, np.linalg.inv(m), r)

    for _ in range(5):  # concave: the interval about the best shrinks
        f = value(s)
        k = int(np.argmax(f))
        s = np.linspace(s[max(0, k - 1)], s[min(len(s) - 1, k + 1)], 21)
    return value(s).max()


def shifts_of(edges, repeats=(True, True, True), most=1):
    """Shifts to the images of a cell (rows of edges), the cell's own first."""
    counts = [sorted(range(-most, most + 1), key=abs) if r else (0,) for r in repeats]
    return [np.array(n) @ edges for n in itertools.product(*counts)]


def distance_to_ellipsoid(points, axes):
    """Of points (n, 3) in the body's axes from its surface, by bisection; 0 inside."""
    axes = np.asarray(axes, float)
    outside = ((points / axes) ** 2).sum(axis=1) > 1
    low, high = np.zeros(len(points)), np.linalg.norm(points, axis=1) * axes.max()
    for _ in range(48):  # sum of (a x / (a^2 + t))^2 = 1
        t = 0.5 * (low + high)
        is_far = ((axes * points / (axes ** 2 + t[:, None])) ** 2).sum(axis=1) > 1
        low, high = np.where(is_far, t, low), np.where(is_far, high, t)
    foot = axes ** 2 * points / (axes ** 2 + t[:, None])
    return np.where(outside, np.linalg.norm(points - foot, axis=1), 0.0)
