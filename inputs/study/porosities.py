"""Porosity of a pile for each reading of "the total area of the pile"."""

import numpy as np

from fits import line, segment
from piles import A, B

CELL = B / 16.0  # of the raster on which areas are counted

READINGS = ("outline, union", "outline, plain sum", "line A-B by height, plain sum", "below the line A-B by height",
            "line A-B by abscissa, plain sum", "below the line A-B by abscissa", "below the centres",
            "below the centres, plain sum", "middle, below the outline", "middle, below the line",
            "inner region, 2 a inside", "inner region, 4 a inside")


def raster(pile, surface):
    """(x of the columns, y of the rows, solid (rows, columns)): what lies in a particle."""
    x = np.arange(0.5, surface.x[-1] / CELL) * CELL
    y = np.arange(0.5, (surface.y.max() + CELL) / CELL) * CELL
    solid = np.zeros((len(y), len(x)), bool)
    for k, (centre, (c, s)) in enumerate(zip(pile.centres, pile.directions)):
        columns = slice(max(0, int((centre[0] - A) / CELL)), int((centre[0] + A) / CELL) + 2)
        rows = slice(max(0, int((centre[1] - A) / CELL)), int((centre[1] + A) / CELL) + 2)
        dx, dy = x[columns][None, :] - centre[0], y[rows][:, None] - centre[1]
        u, v = c * dx + s * dy, c * dy - s * dx
        if pile.subspheres:
            for t, r in pile.spheres:
                solid[rows, columns] |= (u - t) ** 2 + v ** 2 < r * r
        else:
            solid[rows, columns] |= (u / A) ** 2 + (v / B) ** 2 < 1.0
    return x, y, solid


def porosities(pile, surface):
    """{reading: porosity}; lines leave out 20 % at each end, "middle" and "inner region" take the one by height."""
    x, y, solid = raster(pile, surface)
    _, intercept, slope = line(surface)
    first, end = segment(surface, "height", 0.2)
    sum_of_sections = len(pile.centres) * pile.cross_section()
    outline = y[:, None] < np.interp(x, surface.x, surface.y)[None, :]
    below_line = y[:, None] < (intercept + slope * x)[None, :]
    _, flat_intercept, flat_slope = line(surface, "abscissa")
    below_flat_line = y[:, None] < (flat_intercept + flat_slope * x)[None, :]
    seen = surface.seen[np.argsort(surface.seen[:, 0])]
    below_centres = (y[:, None] < np.interp(x, *seen.T)[None, :]) & (x <= seen[-1, 0])[None, :]
    middle = ((x >= surface.x[first]) & (x <= surface.x[end - 1]))[None, :]

    def inner(margin):
        reach = margin * A
        depth = (intercept + slope * x - margin * A * np.hypot(1.0, slope))
        return (x > reach)[None, :] & (y > reach)[:, None] & (y[:, None] < depth[None, :])

    def share(region):
        return 1.0 - np.count_nonzero(solid & region) / np.count_nonzero(region)

    def by_sum(region):
        return 1.0 - sum_of_sections / (np.count_nonzero(region) * CELL ** 2)

    values = (share(outline), by_sum(outline), by_sum(below_line), share(below_line), by_sum(below_flat_line),
              share(below_flat_line), share(below_centres), by_sum(below_centres), share(middle & outline),
              share(middle & below_line), share(inner(2.0)), share(inner(4.0)))
    return dict(zip(READINGS, values))

