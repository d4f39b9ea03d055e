"""The line's fit, read in other ways: what counts as the middle segment A-B, and what the line goes through."""

from dataclasses import dataclass

import numpy as np

from piles import A, B

SPACING = 0.05 * B
CUTS = (0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3)
SEGMENTS = ("height", "abscissa", "slope")
THROUGH = ("envelope", "centres")


@dataclass
class Surface:
    """Free surface of a pile in columns x (C,): heights y, the same averaged over one particle length h, highest
    column and foot (where h first falls below b)."""

    x: np.ndarray
    y: np.ndarray
    h: np.ndarray
    summit: int
    foot: int
    seen: np.ndarray  # (S, 2): centres of the particles that are seen from above


def surface_of(pile):
    right = pile.centres[:, 0].max() + A
    x = SPACING * (np.arange(int(right / SPACING)) + 0.5)
    y = pile.top(x)
    reach = int(A / SPACING)
    sums = np.concatenate([[0.0], np.cumsum(y)])
    first = np.maximum(np.arange(len(x)) - reach, 0)
    last = np.minimum(np.arange(len(x)) + reach + 1, len(x))
    h = (sums[last] - sums[first]) / (last - first)
    summit = int(np.argmax(h))
    low = np.flatnonzero(h[summit:] < B)
    foot = summit + (int(low[0]) if len(low) else len(x) - summit - 1)
    return Surface(x, y, h, summit, foot, seen_from_above(pile, x, y))


def seen_from_above(pile, x, y):
    """Centres of particles whose own outline is the free surface somewhere."""
    seen = []
    for k in range(len(pile.centres)):
        near = np.abs(x - pile.centres[k, 0]) < A
        alone = type(pile)(pile.centres[k:k + 1], pile.directions[k:k + 1], pile.subspheres, pile.spheres)
        if np.any(alone.top(x[near]) >= y[near] - 1e-12) and y[near].size:
            seen.append(pile.centres[k])
    return np.array(seen)


def segment(surface, kind, cut):
    """Columns (first, end) from A to B, `cut` of the whole left out at each end."""
    x, h, top = surface.x, surface.h, surface.summit
    if kind == "height":
        height = h[top]
        below = np.flatnonzero(h[top:] < (1.0 - cut) * height) if cut else np.array([0])
        first = top + int(below[0])
        below = np.flatnonzero(h[first:] < cut * height)
        return first, first + int(below[0]) if len(below) else len(x)
    ends = np.array([[x[top], h[top]], [x[surface.foot], h[surface.foot]]])
    chord = ends[1] - ends[0]
    if kind == "abscissa":
        chord[1] = 0.0
    along = ((x - ends[0, 0]) * chord[0] + (h - ends[0, 1]) * chord[1]) / (chord @ chord)
    inside = np.flatnonzero((along >= cut) & (along <= 1.0 - cut) & (np.arange(len(x)) >= top)
                            & (np.arange(len(x)) <= surface.foot))
    return int(inside[0]), int(inside[-1]) + 1


def line(surface, kind="height", cut=0.2, through="envelope"):
    """(angle in degrees, intercept, slope) of the least squares line."""
    first, end = segment(surface, kind, cut)
    x, y = surface.x[first:end], surface.y[first:end]
    if through == "centres":
        inside = (surface.seen[:, 0] >= x[0]) & (surface.seen[:, 0] <= x[-1])
        x, y = surface.seen[inside].T
    slope, intercept = np.polyfit(x, y, 1)
    return np.degrees(np.arctan(-slope)), intercept, slope


def scan(surface):
    """{(segment, through, cut): angle} of all readings."""
    return {(kind, through, cut): line(surface, kind, cut, through)[0]
            for kind in SEGMENTS for through in THROUGH for cut in CUTS}
