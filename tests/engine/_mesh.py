"""Triangle meshes for the engine tests: STL and VTK files, and the script lines that use them.

A mesh is an array of triangles (T, 3, 3): triangle, corner, coordinate; metres.
"""

from pathlib import Path

import numpy as np

from _engine import LAW


def write_stl(file, triangles):
    lines = ["solid mesh"]
    for corners in np.asarray(triangles, float):
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        lines.append("facet normal " + " ".join(repr(float(x)) for x in normal))
        lines.append("outer loop")
        lines += ["vertex " + " ".join(repr(float(x)) for x in corner) for corner in corners]
        lines += ["endloop", "endfacet"]
    Path(file).write_text("\n".join(lines + ["endsolid mesh"]) + "\n")


def write_vtk(file, triangles):
    triangles = np.asarray(triangles, float)
    count = len(triangles)
    lines = ["# vtk DataFile Version 2.0", "a mesh", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {3 * count} double"]
    lines += [" ".join(repr(float(x)) for x in p) for p in triangles.reshape(-1, 3)]
    lines += [f"CELLS {count} {4 * count}"]
    lines += [f"3 {3 * k} {3 * k + 1} {3 * k + 2}" for k in range(count)]
    lines += [f"CELL_TYPES {count}"] + ["5"] * count
    Path(file).write_text("\n".join(lines) + "\n")


def quad(a, b, c, d):
    """Two triangles (2, 3, 3)."""
    return np.array([[a, b, c], [a, c, d]], float)


def floor(half, cells=1, height=0.0):
    """The square |x|, |z| < half at y = height, as 2 cells^2 triangles."""
    ticks = np.linspace(-half, half, cells + 1)
    return np.concatenate([
        quad((x0, height, z0), (x0, height, z1), (x1, height, z1), (x1, height, z0))
        for x0, x1 in zip(ticks, ticks[1:]) for z0, z1 in zip(ticks, ticks[1:])])


def careless_floor(x, z, noise, seed, cell=1e-3):
    """The rectangle |x| < x, |z| < z at y = 0 as a careless drawing has it: strips of uneven width that are
    divided without regard to each other (T-junctions), slivers of 0.005 to 0.1 cells between some, and every
    corner of every triangle off by up to `noise` (m)."""
    generator = np.random.default_rng(seed)

    def cuts(half, slivers):
        ticks = [-half]
        while ticks[-1] < half:
            is_sliver = generator.random() < slivers
            ticks.append(ticks[-1] + cell * (10.0 ** generator.uniform(-2.3, -1) if is_sliver
                                             else generator.uniform(0.1, 1.0)))
        return ticks

    strips = cuts(x, 0.3)
    triangles = []
    for x0, x1 in zip(strips, strips[1:]):
        ticks = cuts(z, 0.1)
        triangles += [quad((x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0))
                      for z0, z1 in zip(ticks, ticks[1:])]
    triangles = np.concatenate(triangles)
    off = generator.normal(size=triangles.shape)
    off *= noise * generator.random(triangles.shape[:2])[..., None] / np.linalg.norm(off, axis=-1, keepdims=True)
    return triangles + off


def mesh(name, file, more="", style="mesh/surface"):
    """Script line of a mesh of material 1."""
    return f"fix {name} all {style} file {file} type 1 {more}\n"


def mesh_wall(name, meshes, surface="smooth", more="", law=LAW, general=""):
    """Script line of a wall of these meshes."""
    return (f"fix {name} all wall/gran/ellipsoid {law} surface {surface} mesh n_meshes "
            f"{len(meshes)} meshes {' '.join(meshes)} {general} {more}\n")
