"""Contact of two ellipsoids by a formulation that shares nothing with the engine's support functions:
the surface points with opposite normals on one line, from their implicit equations, and the radii of
curvature from the second fundamental form.
"""

import numpy as np


def shape_matrix(semiaxes, rotation):
    """B of the implicit surface x^T B x = 1 (3, 3), 1/m2."""
    return rotation @ np.diag(1.0 / np.asarray(semiaxes, float) ** 2) @ rotation.T


def _solve(residual, start):
    """Newton's method with a complex-step Jacobian, which has no rounding error of its own."""
    x = np.asarray(start, float)
    for _ in range(100):
        jacobian = np.empty((x.size, x.size))
        for k in range(x.size):
            step = x.astype(complex)
            step[k] += 1e-30j
            jacobian[:, k] = residual(step).imag / 1e-30
        change = np.linalg.solve(jacobian, -residual(x))
        x = x + change
        if np.abs(change).max() < 1e-15 * np.abs(x).max():
            return x
    if np.abs(change).max() > 1e-12 * np.abs(x).max():
        raise AssertionError("the reference contact geometry did not converge")
    return x


def _principal_curvatures(shape, point):
    """Principal curvatures (2,) and directions (2, 3) of x^T B x = 1 at a surface point."""
    gradient = shape @ point
    normal = gradient / np.linalg.norm(gradient)
    tangent = np.linalg.svd(normal[None])[2][1:]  # two rows that span the tangent plane
    curvatures, mix = np.linalg.eigh(tangent @ shape @ tangent.T / np.linalg.norm(gradient))
    return curvatures, mix.T @ tangent


def contact(shape_i, shape_j, distance):
    """Common normal from i to j, overlap (m), contact point relative to i (m), reduced radius (m).

    `distance` is x_j - x_i. The overlap is positive when the bodies penetrate.
    """
    length = np.linalg.norm(distance)

    def residual(u):
        # surface points p (of i) and q (of j, seen from j), in units of the distance
        p, q = u[:3] * length, u[3:6] * length
        normal_i, normal_j = shape_i @ p, shape_j @ q
        opposite = normal_j * u[6] + normal_i  # q's normal is against p's
        line = p - distance - q - u[7] * length * normal_i * length  # p - q' along the normal
        return np.concatenate([[p @ normal_i - 1.0, q @ normal_j - 1.0], opposite * length,
                               line / length])

    direction = distance / length
    p0 = direction / np.sqrt(direction @ shape_i @ direction)
    q0 = -direction / np.sqrt(direction @ shape_j @ direction)
    ratio = np.linalg.norm(shape_i @ p0) / np.linalg.norm(shape_j @ q0)
    u = _solve(residual, np.concatenate([p0 / length, q0 / length, [ratio, 0.0]]))
    p, q = u[:3] * length, u[3:6] * length
    normal = shape_i @ p / np.linalg.norm(shape_i @ p)
    overlap = normal @ (p - distance - q)
    return normal, overlap, 0.5 * (p + distance + q), _reduced_radius(shape_i, p, shape_j, q)


def _reduced_radius(shape_i, p, shape_j, q):
    """1 / (2 sqrt(A B)), Markauskas et al. 2010, eq. 19."""
    a, b = gap_curvatures(shape_i, p, shape_j, q)
    return 1.0 / (2.0 * np.sqrt(a * b))


def gap_curvatures(shape_i, p, shape_j, q):
    """Hertz's A and B of the gap A x^2 + B y^2 (Johnson 1985, eqs. 4.3 and 4.4) from the principal
    curvatures at the surface points p and q and the angle between their directions."""
    k_i, directions_i = _principal_curvatures(shape_i, p)
    k_j, directions_j = _principal_curvatures(shape_j, q)
    cosine = min(1.0, abs(directions_i[0] @ directions_j[0]))
    double_angle = 2.0 * np.arccos(cosine)
    difference_i, difference_j = k_i[0] - k_i[1], k_j[0] - k_j[1]
    total = 0.5 * (k_i.sum() + k_j.sum())  # A + B
    split = 0.5 * np.sqrt(difference_i ** 2 + difference_j ** 2
                          + 2.0 * difference_i * difference_j * np.cos(double_angle))
    return 0.5 * (total - split), 0.5 * (total + split)
