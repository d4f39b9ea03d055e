"""The paper's statements, each tested with the runs of one law: confirmed, not confirmed, undecided.

A statement is a quantity of the means and the range where it holds. It is confirmed when its 95 % interval lies in the
range, not confirmed when outside, else undecided. The margin of smooth ellipses is the paper's: 1.8 degrees of
angle (8 %), 4 % of porosity, 2.5 % of the coordination number.
"""

from dataclasses import dataclass

import numpy as np

from statistics_of_runs import drawn_means, interval, verdict

INFINITE = float("inf")


@dataclass
class Statement:
    words: str  # what the paper says
    measured: str  # what is looked at
    key: str  # the quantity
    kinds: tuple  # numbers of sub-spheres that are needed, 0: smooth
    value: object  # of {kind: means}
    below: float
    above: float


def relative(count):
    return lambda m: 100.0 * (m[count] / m[0] - 1.0)


def break_of_slope(m):
    """Change of the mean slope at N = 9, per sub-sphere."""
    return (m[17] - m[9]) / 8.0 - (m[9] - m[3]) / 6.0


def statements():
    angle, z = "repose_angle_deg", "zpp"
    return [
        Statement("the angle falls from N = 3 to N = 17 (29.1 to 23.3 degrees)", "angle(17) - angle(3), deg", angle,
                  (3, 17), lambda m: m[17] - m[3], -INFINITE, 0.0),
        Statement("the fall is up to 25 %", "angle(3) over angle(17) - 1, %", angle, (3, 17),
                  lambda m: 100.0 * (m[3] / m[17] - 1.0), 15.0, 35.0),
        *[Statement(f"N = {n} {'meets' if meets else 'does not meet'} the smooth angle within its margin of 8 %",
                    f"angle({n}) over smooth - 1, %", angle, (0, n), relative(n), -8.0 if meets else 8.0,
                    8.0 if meets else INFINITE) for n, meets in ((5, False), (9, False), (13, True), (17, True))],
        Statement("the slope of the angle over N breaks at N = 9", "slope beyond 9 less slope up to 9, deg per N",
                  angle, (3, 9, 17), break_of_slope, 0.0, INFINITE),
        Statement("the smooth angle is 22.7 +- 1.8 degrees", "smooth angle, deg", angle, (0,), lambda m: m[0], 20.9,
                  24.5),
        Statement("porosity falls from N = 3 to N = 17 (0.25 to 0.14)", "porosity(17) - porosity(3)", "porosity",
                  (3, 17), lambda m: m[17] - m[3], -INFINITE, 0.0),
        Statement("porosity of N = 17 stays above the smooth one's margin of 4 %", "porosity(17) over smooth - 1, %",
                  "porosity", (0, 17), relative(17), 4.0, INFINITE),
        Statement("the smooth porosity is 0.13 +- 4 %", "smooth porosity", "porosity", (0,), lambda m: m[0],
                  0.13 * 0.96, 0.13 * 1.04),
        Statement("Zpp of N = 9 meets the smooth one within 2.5 %", "Zpp(9) over smooth - 1, %", z, (0, 9),
                  relative(9), -2.5, 2.5),
        Statement("Zpp of N = 17 is the smooth one's", "Zpp(17) over smooth - 1, %", z, (0, 17), relative(17), -2.5,
                  2.5),
        Statement("the smooth coordination number is 3.90 +- 2.5 %", "smooth Zpp", z, (0,), lambda m: m[0],
                  3.90 * 0.975, 3.90 * 1.025),
        Statement("Zss grows with N from 7 on", "Zss(17) - Zss(7)", "zss", (7, 17), lambda m: m[17] - m[7], 0.0,
                  INFINITE),
    ]


def test(statement, groups):
    """(value, low, high, verdict) with the runs {key: {kind: [value, ...]}}; None for what is not there."""
    runs = groups[statement.key]
    missing = [k for k in statement.kinds if k not in runs]
    if missing:
        return None, None, None, "no runs of " + ", ".join("smooth" if k == 0 else f"N = {k}" for k in missing)
    value = statement.value({k: np.mean(runs[k]) for k in statement.kinds})
    draws = drawn_means(runs)
    if not draws:
        return value, None, None, "undecided (one run each)"
    low, high = interval(statement.value({k: draws[k] for k in statement.kinds}))
    return value, low, high, verdict(low, high, statement.below, statement.above)
