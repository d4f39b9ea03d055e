"""Which ellipsoids overlap, and by how much, by the function of Perram and Wertheim (J. Comput. Phys. 58,
409, 1985): it shares nothing with the engine's search. Quantities are those of one frame of a dump.
"""

import numpy as np

from _engine import rotation, vectors


def shape_squares(columns):
    """S = R diag(a^2, b^2, c^2) R^T of each particle (N, 3, 3), m2, of the first frame."""
    axes = vectors(columns, "shapex", "shapey", "shapez")[0]
    quaternions = vectors(columns, *(f"quat{k}" for k in (1, 2, 3, 4)))[0]
    turn = np.stack([rotation(q) for q in quaternions])
    return np.einsum("nij,nj,nkj->nik", turn, axes ** 2, turn)


def scales(columns, periods):
    """Pairs (P, 2) of indices whose bounding spheres overlap, and the factor (P,) by which both bodies
    have to be scaled about their centres to touch: below 1 where they overlap.

    `periods` are the lengths (3,) of the box, infinite where it is not periodic (m).
    """
    place = vectors(columns, *"xyz")[0]
    reach = vectors(columns, "shapex", "shapey", "shapez")[0].max(1)
    i, j = np.triu_indices(len(place), 1)
    apart = place[j] - place[i]
    periods = np.asarray(periods, float)
    periodic = np.isfinite(periods)
    apart[:, periodic] -= periods[periodic] * np.round(apart[:, periodic] / periods[periodic])
    near = (apart ** 2).sum(1) < (reach[i] + reach[j]) ** 2
    i, j, apart = i[near], j[near], apart[near]
    squares = shape_squares(columns)
    return np.stack([i, j], axis=1), np.sqrt(contact_function(squares[i], squares[j], apart))


def touching(columns, periods):
    """Pairs (P, 2) of indices that overlap."""
    pairs, factors = scales(columns, periods)
    return pairs[factors < 1.0]


def contact_function(squares_i, squares_j, apart):
    """F (P,), the square of the factor above: the maximum over t in (0, 1) of
    t (1 - t) r^T ((1 - t) S_i + t S_j)^-1 r, which is concave, by golden sections."""
    def value(t):
        mixed = (1.0 - t)[:, None, None] * squares_i + t[:, None, None] * squares_j
        return t * (1.0 - t) * (apart * np.linalg.solve(mixed, apart[..., None])[..., 0]).sum(1)

    golden = 0.5 * (np.sqrt(5.0) - 1.0)
    low, high = np.zeros(len(apart)), np.ones(len(apart))
    for _ in range(45):  # golden^45 = 4e-10: F is flat there, exact to rounding
        left, right = high - golden * (high - low), low + golden * (high - low)
        rises = value(left) < value(right)
        low, high = np.where(rises, left, low), np.where(rises, high, right)
    return value(0.5 * (low + high))
