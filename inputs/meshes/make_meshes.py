#!/usr/bin/env python3
"""Writes the meshes of inputs/hopper.in (hopper and silo), drum.in and benchmark_*.in into the present folder:
ASCII STL in metres.

    python3 make_meshes.py

To change a mesh change the numbers in main(). A wall is a surface without thickness: particles may touch
either side.
"""

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
    segments = 24
    outlet, shoulder = ring(0.010, 0.040, segments), ring(0.030, 0.075, segments)
    write_stl("hopper.stl", band(outlet, shoulder) + band(shoulder, ring(0.030, 0.150, segments)))
    write_stl("hopper_lid.stl", disc(outlet))
    wall = ring(0.030, 0.040, segments)
    write_stl("silo.stl", band(outlet, wall) + band(wall, ring(0.030, 0.150, segments)))
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
