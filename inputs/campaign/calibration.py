"""The value of a variable at which a measured quantity has a wanted value, with its uncertainty.

A parabola (a line for two values) is fitted by least squares through all runs; the scatter of one run is pooled over
the values. The uncertainty of the result is one standard error of the fitted curve there over its slope.
"""

import math
from dataclasses import dataclass

from options import Misuse
from results import tool, write_rows


@dataclass
class Curve:
    """coefficients (m,) of powers of (x - middle) / half; covariance (m, m) of them."""

    middle: float
    half: float
    coefficients: list
    covariance: list
    misfit: float  # rms distance of the means from the curve, in their standard errors; nan: as many as coefficients

    def powers(self, x):
        return [((x - self.middle) / self.half) ** k for k in range(len(self.coefficients))]

    def at(self, x):
        return sum(c * p for c, p in zip(self.coefficients, self.powers(x)))

    def error(self, x):
        p, c = self.powers(x), self.covariance
        return math.sqrt(sum(p[i] * c[i][j] * p[j] for i in range(len(p)) for j in range(len(p))))

    def slope(self, x):
        u = (x - self.middle) / self.half
        return sum(k * c * u ** (k - 1) for k, c in enumerate(self.coefficients) if k) / self.half


def inverse(matrix):
    """Of a small regular matrix, by Gauss and Jordan."""
    n = len(matrix)
    rows = [[*row, *(float(i == j) for j in range(n))] for i, row in enumerate(matrix)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [v / rows[k][k] for v in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [v - rows[i][k] * w for v, w in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


def mean(values):
    return sum(values) / len(values)


def pooled_variance(groups):
    """Of one run about the mean of its value of the variable."""
    squares = sum((v - mean(values)) ** 2 for values in groups.values() for v in values)
    return squares / (sum(len(values) for values in groups.values()) - len(groups))


def fit(groups):
    """Curve through {x: [value, ...]}; at least two x, and two values somewhere."""
    xs = sorted(groups)
    middle, half = 0.5 * (xs[0] + xs[-1]), 0.5 * (xs[-1] - xs[0])
    order = min(3, len(xs))
    curve = Curve(middle, half, [0.0] * order, [], math.nan)
    normal = [[0.0] * order for _ in range(order)]
    right = [0.0] * order
    for x, values in groups.items():
        p = curve.powers(x)
        for i in range(order):
            right[i] += p[i] * sum(values)
            for j in range(order):
                normal[i][j] += p[i] * p[j] * len(values)
    solved = inverse(normal)
    variance = pooled_variance(groups)
    curve.coefficients = [sum(s * r for s, r in zip(row, right)) for row in solved]
    curve.covariance = [[variance * v for v in row] for row in solved]
    if len(xs) > order and variance > 0.0:
        chi2 = sum(len(v) * (mean(v) - curve.at(x)) ** 2 / variance for x, v in groups.items())
        curve.misfit = math.sqrt(chi2 / (len(xs) - order))
    return curve


def crossings(curve, low, high, wanted, parts=1000):
    """Abscissas from low to high where the curve has the wanted value; bisection between sample points."""
    found = []
    for k in range(parts):
        left, right = (low + (high - low) * j / parts for j in (k, k + 1))
        if (curve.at(left) < wanted) == (curve.at(right) < wanted):
            continue
        rises = curve.at(left) < wanted
        for _ in range(60):
            x = 0.5 * (left + right)
            left, right = (x, right) if (curve.at(x) < wanted) == rises else (left, x)
        found.append(0.5 * (left + right))
    return found


def solve(groups, wanted, name, column):
    """(curve, value of the variable, its standard error); raises Misuse where there is no one value."""
    if len(groups) < 2 or not any(len(v) > 1 for v in groups.values()):
        raise Misuse(f"--calibrate needs two values of {name} or more, and two seeds or more")
    curve = fit(groups)
    low, high = min(groups), max(groups)
    found = crossings(curve, low, high, wanted)
    if len(found) != 1:
        values = [curve.at(low + (high - low) * k / 100) for k in range(101)]
        what = "not reached" if not found else f"reached {len(found)} times"
        raise Misuse(f"{column} = {wanted:g} is {what} for {name} from {low:g} to {high:g}, where the fitted curve goes "
                     f"from {values[0]:.4g} to {values[-1]:.4g} (between {min(values):.4g} and {max(values):.4g}); "
                     "choose other values of --vary")
    return curve, found[0], curve.error(found[0]) / abs(curve.slope(found[0]))


def parse(text):
    """(name, column, value) of NAME:COLUMN=VALUE."""
    name, colon, rest = text.partition(":")
    column, sign, value = rest.partition("=")
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not (name and colon and column and sign and math.isfinite(number)):
        raise Misuse(f"--calibrate is '{text}', allowed is NAME:COLUMN=VALUE, for example mu:repose_angle_deg=25")
    return name, column, number


def grouped(rows, name, column):
    """{x: [value, ...]} of the table's rows; other variables must not vary."""
    groups = {}
    for row in rows:
        try:
            x, value = float(row[name]), float(row.get(column, ""))
        except ValueError:
            raise Misuse(f"--calibrate: run {row['run']} has {name} = '{row[name]}' and {column} = "
                         f"'{row.get(column, '')}', numbers are needed") from None
        groups.setdefault(x, []).append(value)
    return dict(sorted(groups.items()))


def draw(campaign, table, curve, name, column, points=100):
    """Means with half ranges, and the curve: so many points that they have no markers."""
    low, high = float(table[0][name]), float(table[-1][name])
    drawn = [{key: row[key] for key in (name, column, "half_range")} for row in table]
    for k in range(points + 1):
        x = low + (high - low) * k / points
        drawn.append({name: f"{x:.9g}", "fit": f"{curve.at(x):.9g}"})
    write_rows(campaign.out / "calibration_curve.csv", drawn)
    tool(campaign, "plot", "curve", campaign.out / "calibration_curve.csv", "--x", name, "--y", f"{column},fit",
         "--margin", "half_range", "--title", f"{column} over {name}", "-o", campaign.out / "calibration.png")


def report(campaign, rows, asked):
    """Table, picture and result, printed and written to calibration.csv and calibration.png."""
    name, column, wanted = asked
    groups = grouped(rows, name, column)
    curve, x, error = solve(groups, wanted, name, column)
    scatter = math.sqrt(pooled_variance(groups))
    print(f"=== Calibration: {column} over {name}\n{name:>12} {'runs':>5} {'mean':>10} {'error':>10} "
          f"{'half range':>10} {'fit':>10}")
    table = []
    for value, values in groups.items():
        row = {name: f"{value:g}", "runs": len(values), column: f"{mean(values):.6g}",
               "standard_error": f"{scatter / math.sqrt(len(values)):.4g}",
               "half_range": f"{0.5 * (max(values) - min(values)):.4g}", "fit": f"{curve.at(value):.6g}"}
        table.append(row)
        print("{:>12} {:>5} {:>10} {:>10} {:>10} {:>10}".format(*row.values()))
    write_rows(campaign.out / "calibration.csv", table)
    draw(campaign, table, curve, name, column)
    if curve.misfit > 2.0:
        print(f"the means lie {curve.misfit:.1f} of their standard errors off the curve: narrow the range of --vary")
    print(f"{column} = {wanted:g} at {name} = {x:.4g} +- {error:.2g} (one standard error)")
