"""Piles of the results as discs and ellipses in the plane: free surface, fits of its slope, porosities.

Written apart from ellipsoid-post, with numpy: what both measure must agree.
"""

import csv
import io
import lzma
import gzip
import subprocess
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

A, B = 2.7e-3, 1.15e-3


@dataclass
class Pile:
    """K particles in the plane: centres (K, 2) and directions of the long axes (K, 2); m."""

    centres: np.ndarray
    directions: np.ndarray
    subspheres: int  # 0: smooth
    spheres: np.ndarray  # (N, 2): abscissas on the axis, radii; (0, 2) when smooth

    def top(self, x):
        """y_max at the abscissas x (C,); 0 where there is no particle."""
        result = np.zeros(len(x))
        if self.subspheres:
            discs = self.discs()
            for (cx, cy), r in discs:
                inside = np.abs(x - cx) < r
                result[inside] = np.maximum(result[inside], cy + np.sqrt(r * r - (x[inside] - cx) ** 2))
            return result
        for centre, (c, s) in zip(self.centres, self.directions):
            u = x - centre[0]
            p = (s / A) ** 2 + (c / B) ** 2  # quadratic form of y, of x y, of x
            q = c * s * (1.0 / A ** 2 - 1.0 / B ** 2)
            r = (c / A) ** 2 + (s / B) ** 2
            root = (q * u) ** 2 - p * (r * u * u - 1.0)
            inside = root > 0.0
            result[inside] = np.maximum(result[inside],
                                        centre[1] + (-q * u[inside] + np.sqrt(root[inside])) / p)
        return result

    def discs(self):
        """((x, y), radius) of all sub-spheres."""
        return [((c + t * d), r) for c, d in zip(self.centres, self.directions) for t, r in self.spheres]

    def cross_section(self):
        """Area of one particle: pi a b (2), or of the cut-off discs (9)."""
        if not self.subspheres:
            return np.pi * A * B
        x = np.linspace(-A, A, 200001)
        half = np.zeros(len(x))
        for t, r in self.spheres:
            inside = np.abs(x - t) < r
            half[inside] = np.maximum(half[inside], np.sqrt(r * r - (x[inside] - t) ** 2))
        return 2.0 * np.sum(half) * (x[1] - x[0])


@lru_cache
def spheres_of(tools, subspheres):
    """(N, 2) of a template of the paper."""
    text = subprocess.run([tools, "template", "--aspect", repr(A / B), "--b", repr(B), "--subspheres", str(subspheres),
                           "--spheres", "-"], capture_output=True, text=True, check=True).stdout
    rows = list(csv.reader(io.StringIO(text)))
    numbers = np.array([[float(v) for v in row] for row in rows[1:]])
    return numbers[:, [rows[0].index("x_m"), rows[0].index("radius_m")]]


def read_text(file):
    data = Path(file).read_bytes()
    opener = {".gz": gzip.decompress, ".xz": lzma.decompress}.get(Path(file).suffix, bytes)
    return opener(data).decode()


def read_pile(tools, file):
    """The pile at the wall; particles that lie apart on the floor are left out by `connected`."""
    lines = read_text(file).splitlines()
    names = lines[8].split()[2:]
    columns = np.array([[float(v) for v in line.split()] for line in lines[9:]])
    get = {name: columns[:, k] for k, name in enumerate(names)}
    q = np.stack([get[f"quat{k}"] for k in range(1, 5)])
    directions = np.stack([1.0 - 2.0 * (q[2] ** 2 + q[3] ** 2), 2.0 * (q[1] * q[2] + q[0] * q[3])], axis=1)
    count = int(get["f_subspheres"][0])
    spheres = spheres_of(tools, count) if count else np.zeros((0, 2))
    centres = np.stack([get["x"], get["y"]], axis=1)
    keep = connected(centres, directions)
    return Pile(centres[keep], directions[keep], count, spheres)


def connected(centres, directions):
    """Mask of the particles that hang together with those at the wall: ellipses sampled by 48 points, nearer than
    b / 5. Good enough to leave out particles that lie alone."""
    angle = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    local = np.stack([A * np.cos(angle), B * np.sin(angle)])
    normal = np.stack([-directions[:, 1], directions[:, 0]], axis=1)
    points = centres[:, None] + local[0][:, None] * directions[:, None] + local[1][:, None] * normal[:, None]
    grown = np.zeros(len(centres), bool)
    front = list(np.flatnonzero(points[:, :, 0].min(axis=1) < 0.3 * B))
    grown[front] = True
    while front:
        k = front.pop()
        near = np.flatnonzero(~grown & (np.hypot(*(centres - centres[k]).T) < 2.2 * A))
        for j in near:
            d = points[j] - centres[k]
            u, v = d @ directions[k], d @ normal[k]
            if np.min(np.hypot(u / (A + 0.2 * B), v / (1.2 * B))) < 1.0:
                grown[j] = True
                front.append(j)
    return grown
