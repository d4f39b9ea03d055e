#!/usr/bin/env python3
"""Writes the meshes of inputs/hopper.in (hopper and silo), drum.in and benchmark_*.in into the present folder:
ASCII STL in metres.

    python3 make_meshes.py
    python3 make_meshes.py --edge 1.5e-3      (only the benchmark's drum, of triangles with edges of about 1.5 mm)

To change a mesh change the numbers in write_all() or benchmark(). A wall is a surface without thickness: particles may touch
either side.
"""

import argparse
import math


def ring(radius, height, segments):
    """Corners of a regular polygon about the z axis; the first stands on the x axis."""
    angles = [2.0 * math.pi * k / segments for k in range(segments)]
    return [(radius * math.cos(t), radius * math.sin(t), height) for t in angles]


def band(lower, upper):
    """Triangles between two rings of as many corners."""
    triangles = []
    for k, corner in enumerate(lower):
        after = (k + 1) % len(lower)
        triangles += [(corner, lower[after], upper[after]), (corner, upper[after], upper[k])]
    return triangles


def disc(corners):
    """Triangles of a polygon with its centre."""
    centre = (0.0, 0.0, corners[0][2])
    return [(corners[k], corners[(k + 1) % len(corners)], centre) for k in range(len(corners))]


def fine_tube(radius, lower, upper, edge):
    """A cylinder about the z axis, of triangles with edges of about `edge`."""
    segments, rows = math.ceil(2.0 * math.pi * radius / edge), math.ceil((upper - lower) / edge)
    rings = [ring(radius, lower + (upper - lower) * k / rows, segments) for k in range(rows + 1)]
    return [triangle for k in range(rows) for triangle in band(rings[k], rings[k + 1])]


def fine_disc(radius, edge):
    """A disc of triangles with edges of about `edge`: the k-th ring about its centre has 6 k corners."""
    count, centre, triangles = math.ceil(radius / edge), [(0.0, 0.0, 0.0)], []
    rings = [centre] + [ring(radius * k / count, 0.0, 6 * k) for k in range(1, count + 1)]
    for k in range(1, count + 1):
        inner, outer = rings[k - 1], rings[k]
        for sector in range(6):
            first, begin = sector * (k - 1), sector * k
            for n in range(k):
                near, corner = inner[(first + n) % len(inner)], outer[begin + n]
                triangles.append((corner, outer[(begin + n + 1) % len(outer)], near))
                if n > 0:
                    triangles.append((inner[first + n - 1], corner, near))
    return triangles


def along_y(triangles):
    """The z axis becomes the y axis."""
    return [tuple((x, z, -y) for x, y, z in triangle) for triangle in triangles]


def write_stl(name, triangles):
    with open(name, "w", encoding="ascii") as file:
        file.write(f"solid {name}\n")
        for triangle in triangles:
            file.write("facet normal 0 0 0\nouter loop\n")
            for corner in triangle:
                file.write("vertex " + " ".join(f"{round(x, 9) + 0.0:.6g}" for x in corner) + "\n")
            file.write("endloop\nendfacet\n")
        file.write(f"endsolid {name}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--edge", type=float, help="m, 1e-4 to 0.03: only the benchmark's drum, with edges of this length")
    edge = parser.parse_args().edge
    if edge is None:
        write_all()
    elif 1e-4 <= edge <= 0.03:
        write_stl("benchmark_shell.stl", along_y(fine_tube(0.1, -0.03, 0.03, edge)))
        write_stl("benchmark_disc.stl", fine_disc(1.0, edge / 0.1))
    else:
        parser.error(f"--edge is {edge}; allowed are 1e-4 to 0.03 (metres)")


def write_all():
    segments = 24
    outlet, shoulder = ring(0.010, 0.040, segments), ring(0.030, 0.075, segments)
    write_stl("hopper.stl", band(outlet, shoulder) + band(shoulder, ring(0.030, 0.150, segments)))
    write_stl("hopper_lid.stl", disc(outlet))
    narrow = ring(0.004, 0.040, segments)
    write_stl("hopper_narrow.stl", band(narrow, shoulder) + band(shoulder, ring(0.030, 0.150, segments)))
    wall = ring(0.030, 0.040, segments)
    write_stl("silo.stl", band(outlet, wall) + band(wall, ring(0.030, 0.300, segments)))
    base = ring(0.025, 0.0, 48)
    write_stl("dish.stl", disc(base) + band(base, ring(0.025, 0.002, 48)))
    ends = ring(0.030, -0.010, 36), ring(0.030, 0.010, 36)
    write_stl("drum.stl", along_y(band(*ends) + disc(ends[0]) + disc(ends[1])))
    benchmark()


def benchmark():
    """Walls of the common benchmark: two cones of 45 degrees, whose shoulders have the radius 0.1; the shell of a drum
    about the y axis; a disc of radius 1 for lids and covers, to be scaled."""
    segments = 100
    for name, radius, height in (("large", 0.03, -0.0554222), ("small", 0.02, -0.0593008)):
        orifice, shoulder = ring(radius, height, segments), ring(0.1, height + 0.1 - radius, segments)
        write_stl(f"benchmark_cone_{name}.stl", band(orifice, shoulder))
    write_stl("benchmark_shell.stl", along_y(band(ring(0.1, -0.03, segments), ring(0.1, 0.03, segments))))
    write_stl("benchmark_disc.stl", disc(ring(1.0, 0.0, segments)))


if __name__ == "__main__":
    main()
