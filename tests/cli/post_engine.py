# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""What the engine writes is read back: contact lists, VTK files of every kind, force chains.

60 particles, settled between two walls, smooth and of 5 sub-spheres. Contacts that
ellipsoid-post recomputes from positions must be those of the engine's own list, pair by pair.
"""
import csv
import json
import math
import os
import sys

import numpy as np

from _synthetic import A, B, post, rows_of

sys.path.insert(0, os.path.join(os.environ["ELLIPSOID_SOURCE"], "tests", "engine"))
from _engine import LAW, Particle, Setup, quaternion_of, run, thermo  # noqa: E402

STEPS = 60000
WIDTH = 0.035  # of the container (m)
COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 "
           "shapex shapey shapez")
LIST = "id contactPoint normal delta force"  # 2 + 3 + 3 + 1 + 3 columns


def layers():
    """6 x 10 particles in layers over the floor, turned at random in the plane."""
    random = np.random.default_rng(11)
    return [Particle((A * (1.01 + 2.05 * (k % 6)), A * (1.0 + 2.02 * (k // 6)), 0.0), (A, B, B),
                     quaternion_of((0, 0, 1), random.uniform(0, math.pi)), mass=2e-5)
            for k in range(60)]


def simulate(name, surface, ranks=1, more_dumps=""):
    """Lets the particles settle; dumps of the last step: NAME.dump, NAME.pairs and `more_dumps`."""
    setup = Setup(box=(0.0, WIDTH, 0.0, 0.06, -0.01, 0.01), boundary="m m f",
                  pair=f"gran/ellipsoid {LAW} surface {surface}", time_step=1e-5)
    script = setup.with_particles(layers(), f"{name}.data")
    script = script.replace("read_data", f"processors {ranks} 1 1\nread_data", 1)
    columns = COLUMNS
    if surface != "smooth":
        script += "fix subspheres all property/atom subspheres scalar yes yes no 5\n"
        columns += " f_subspheres"
    for wall, plane in ("left", "xplane 0.0"), ("right", f"xplane {WIDTH}"), ("floor", "yplane 0.0"):
        script += (f"fix {wall} all wall/gran/ellipsoid {LAW} surface {surface} "
                   f"primitive type 1 {plane}\n")
    places = " ".join(f"c_list[{k}]" for k in range(1, 13))
    digits = '"' + " ".join(["%.17g"] * 12) + '"'
    script += ("fix weight all gravity 9.81 vector 0 -1 0\nfix motion all nve/ellipsoid planar yes\n"
               f"compute list all pair/ellipsoid/local {LIST}\n"
               f"dump text all custom {STEPS} {name}.*.dump {columns}\n"
               f'dump_modify text sort id format "%d %d {"%.17g " * (columns.count(" ") - 1)}"\n'
               f"dump pairs all local {STEPS} {name}.*.pairs {places}\ndump_modify pairs format {digits}\n"
               + more_dumps.format(name=name, columns=columns) + f"run {STEPS}\n")
    run(script, ranks, name=f"in.{name}")


def engine_contacts(file):
    """Rows of a contact list as (ids, point, normal, overlap), by ids."""
    with open(file, encoding="ascii") as text:
        rows = [[float(word) for word in line.split()] for line in text.readlines()[9:]]
    return sorted(((int(r[0]), int(r[1])), r[2:5], r[5:8], r[8]) for r in rows)


def recomputed_contacts(file):
    """The same from `contacts --list`."""
    post("contacts", file, "--list", "list.csv", "--quiet")
    with open("list.csv", encoding="ascii") as text:
        rows = list(csv.DictReader(text))
    return sorted(((int(r["id_1"]), int(r["id_2"])),
                   [float(r[f"point_{n}_m"]) for n in "xyz"],
                   [float(r[f"normal_{n}"]) for n in "xyz"], float(r["overlap_m"])) for r in rows)


def check_contacts(name):
    """Same pairs, points, normals and overlaps to the digits that the kernel leaves."""
    ours, theirs = recomputed_contacts(f"{name}.{STEPS}.dump"), engine_contacts(f"{name}.{STEPS}.pairs")
    assert [c[0] for c in ours] == [c[0] for c in theirs], (len(ours), len(theirs))
    assert len(ours) > 80, len(ours)
    worst = [max(np.abs(np.subtract(o[k], t[k])).max() for o, t in zip(ours, theirs))
             for k in (1, 2, 3)]
    print(f"{name}: {len(ours)} contacts of {len({c[0] for c in ours})} pairs; largest differences: "
          f"points {worst[0] / B:.1e} b, normals {worst[1]:.1e}, overlaps {worst[2] / B:.1e} b")
    # the engine starts its search from the last step's normal, the tools from scratch; both stop
    # within 1e-9 rad, which moves the point by as much of a semi-axis, the overlap by its square
    assert worst[0] < 1e-8 * B and worst[1] < 1e-8 and worst[2] < 1e-12 * B, worst
    (coordination,) = rows_of("coordination", f"{name}.{STEPS}.dump", "--cluster-gap", 10)
    assert int(coordination["contacts"]) == len({c[0] for c in theirs})
    assert abs(float(coordination["zss"]) - 2 * len(theirs) / 60) < 1e-12
    largest = max(t[3] for t in theirs)
    assert abs(float(coordination["largest_overlap_b"]) * B / largest - 1) < 1e-9
    (listed,) = rows_of("coordination", f"{name}.{STEPS}.dump", "--cluster-gap", 10, "--contacts",
                        f"{name}.*.pairs", "--id-columns", "c_list[1]", "c_list[2]",
                        "--overlap-column", "c_list[9]")
    for key, value in coordination.items():
        same = listed[key] == value
        assert same or abs(float(listed[key]) / float(value) - 1) < 1e-9, (key, listed[key], value)


def check_force_chains(name):
    """Forces of the list: their mean, and lines between the particles in the picture."""
    with open(f"{name}.{STEPS}.pairs", encoding="ascii") as text:
        forces = [math.hypot(*map(float, line.split()[9:12])) for line in text.readlines()[9:]]
    columns = [f"c_list[{k}]" for k in range(1, 13)]
    normals, force = ("--normal-columns", *columns[5:8]), ("--force-columns", *columns[9:12])
    (found,) = rows_of("contacts", f"{name}.{STEPS}.pairs", "--local", *normals, *force)
    assert abs(float(found["mean_force_N"]) / np.mean(forces) - 1) < 1e-12
    assert abs(float(found["largest_force_N"]) / max(forces) - 1) < 1e-12
    chains = ("--contacts", f"{name}.*.pairs", "--id-columns", *columns[:2], *force)
    pairs = len({c[0] for c in engine_contacts(f"{name}.{STEPS}.pairs")})
    post("render", f"{name}.{STEPS}.dump", "-o", f"{name}_without.svg", "--no-fit")
    post("render", f"{name}.{STEPS}.dump", "-o", f"{name}_chains.svg", "--no-fit", *chains, *normals)
    with open(f"{name}_without.svg", encoding="utf8") as without, \
            open(f"{name}_chains.svg", encoding="utf8") as file:
        lines = file.read().count("<poly") - without.read().count("<poly")
    assert lines == pairs + 1, (lines, pairs)  # and the one of the scale
    post("render", f"{name}.{STEPS}.dump", "-o", f"{name}_chains.png", *chains)
    post("render", f"{name}.{STEPS}.dump", "-o", "x.svg", "--contacts", f"{name}.{STEPS}.pairs", expect=2)
    _, error = post("render", f"{name}.{STEPS}.dump", "-o", "x.svg", *chains[:2], "--id-columns",
                    columns[2], columns[3], *force, expect=1)
    assert "the id of a particle" in error, error
    _, error = post("render", f"{name}.0.dump", "-o", "x.svg", "--contacts", f"{name}.{STEPS}.pairs",
                    *chains[2:], expect=1)
    assert "no contacts of time step 0" in error, error


def check_broken_vtk(name):
    """XML that is cut or damaged: VTK's own reason in one line, no missing columns."""
    for kind in f"{name}_poly.{STEPS}.vtp", f"{name}_cloud.{STEPS}.vtu":
        with open(kind, "rb") as file:
            whole = file.read()
        broken = f"broken_{kind}"
        for text in whole[:len(whole) // 2], whole.replace(b"<PointData>", b"<PointData\xff>", 1):
            with open(broken, "wb") as file:
                file.write(text)
            out, error = post("coordination", broken, "--no-wall", expect=1)
            assert out == "" and error.count("\n") == 1, (out, error)
            assert f"{broken}: frame 1: expected a whole VTK file" in error and "broken file" in error, error


VTK_DUMPS = """dump legacy all custom/vtk {steps} {{name}}.*.vtk {{columns}}
dump packed all custom/vtk {steps} {{name}}_binary.*.vtk {{columns}}
dump_modify packed binary yes
dump poly all custom/vtk {steps} {{name}}_poly.*.vtp {{columns}}
dump cloud all custom/vtk {steps} {{name}}_cloud.*.vtu {{columns}}
dump parts all custom/vtk {steps} {{name}}_parts_*.pvtu {{columns}}
""".format(steps=STEPS)


def check_vtk(name):
    """Every VTK file of the host gives the figures of the text dump, within its precision."""
    options = ("--no-wall", "--cluster-gap", 10, "--contact-gap", 1e-3)
    (text,) = rows_of("coordination", f"{name}.{STEPS}.dump", *options)
    (area,) = rows_of("porosity", f"{name}.{STEPS}.dump", *options[:3])
    (energy,) = json.loads(post("energy", f"{name}.{STEPS}.dump", "--json", "-")[0])
    # .vtk as text has six digits, the others single precision for positions
    for kind, precision in ((".", 5e-6), ("_binary.", 2e-7), ("_poly.", 2e-7), ("_cloud.", 2e-7),
                            ("_parts_", 2e-7)):
        file = next(f for f in sorted(os.listdir(".")) if f.startswith(name + kind)
                    and f"{STEPS}." in f and "box" not in f and f.endswith(("vtk", "vtp", "vtu", "pvtu")))
        (found,) = rows_of("coordination", file, *options)
        assert found["particles"] == text["particles"] == "60", file
        assert found["timestep"] == str(STEPS), (file, found["timestep"])
        assert (found["zpp"], found["zss"]) == (text["zpp"], text["zss"]), (file, found, text)
        (vtk_area,) = rows_of("porosity", file, *options[:3])
        (vtk_energy,) = json.loads(post("energy", file, "--json", "-")[0])
        differences = [abs(float(vtk_area[key]) / float(area[key]) - 1)
                       for key in ("total_area_m2", "solid_area_m2", "pile_height_m")]
        differences.append(abs(vtk_energy["potential_J"] / energy["potential_J"] - 1))
        print(f"{file}: areas, height and energy differ by {max(differences):.1e}")
        assert max(differences) < precision, (file, differences)


def check_host_template():
    """The words that `template --mass` prints make the host's rigid body."""
    a, b, mass = 2.7e-3, 1.15e-3, 2e-5
    _, words = post("template", "--aspect", a / b, "--subspheres", 5, "--multisphere", "body.txt",
                    "--mass", mass, "--quiet")
    words = words.split("particletemplate/multisphere: ")[1].strip()
    setup = Setup(box=(0.0, 0.05) * 3, pair=f"gran {LAW}", atom_style="sphere", time_step=1e-6)
    columns = "id id_multisphere x y z radius"
    run(setup.without_particles()
        + f"fix grain all particletemplate/multisphere 10037 atom_type 1 density constant 1340 {words}\n"
        "fix mixture all particledistribution/discrete 10039 1 grain 1.0\n"
        "region all block 0.01 0.04 0.01 0.04 0.01 0.04 units box\nfix bodies all multisphere\n"
        "fix fill all insert/pack seed 15485863 distributiontemplate mixture insert_every once &\n"
        "    overlapcheck yes orientation random region all particles_in_region 1\n"
        f'run 1\ndump d all custom 1 body.dump {columns}\ndump_modify d format "%d %d %.16g %.16g %.16g %.16g"\n'
        "run 0\n", name="in.body")
    (row,) = rows_of("coordination", "body.dump", "--no-wall")
    assert row["particles"] == "1" and row["subspheres"] == "5", row
    (orientation,) = rows_of("orientation", "body.dump")
    assert orientation["subspheres"] == "5", orientation


FACE = "solid face\n" + "".join(
    "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} 0.0\n" for x, y in corners) + "endloop\nendfacet\n"
    for corners in (((-0.02, -0.02), (0.02, -0.02), (-0.02, 0.02)), ((0.02, -0.02), (0.02, 0.02), (-0.02, 0.02)))) + "endsolid face\n"


def check_flow():
    """Bodies that fall and collide above an opening: number and mass through it as fix massflow/mesh counts them."""
    with open("face.stl", "w", encoding="ascii") as file:
        file.write(FACE)
    random, steps, step = np.random.default_rng(7), 20000, 1e-5
    particles = [Particle((0.007 * (k % 5) - 0.014, 0.007 * (k // 5 % 5) - 0.014, 0.004 + 0.007 * (k // 25)),
                          (2.7e-3, 1.5e-3, 1.15e-3), quaternion_of(random.normal(size=3), random.uniform(0, math.pi)),
                          tuple(random.normal(0, 0.15, 3)), mass=random.uniform(1e-5, 3e-5)) for k in range(75)]
    run(Setup(box=(-0.06, 0.06, -0.06, 0.06, -0.3, 0.06), boundary="m m m", time_step=step).with_particles(particles) + f"""
fix motion all nve/ellipsoid
fix weight all gravity 9.81 vector 0 0 -1
fix cad all mesh/surface/planar file face.stl type 1
fix flux all massflow/mesh mesh cad count once vec_side 0 0 -1
dump d all custom 250 fall.dump id type mass x y z quat1 quat2 quat3 quat4 shapex shapey shapez
dump_modify d sort id format "%d %d {"%.16g " * 11}"
thermo 250
thermo_style custom step f_flux[1] f_flux[2]
thermo_modify norm no lost ignore format float %.12g
run {steps}
""", name="in.flow")
    counted = thermo("log.in.flow", 3)
    rows = rows_of("flow", "fall.dump", "--face", "face.stl", "--dt", step)
    mass, number = np.cumsum([[float(r["mass_backward_kg"]), float(r["backward"])] for r in rows], axis=0).T
    assert number[-1] > 40 and all(int(r["forward"]) == 0 for r in rows), number
    # the host looks every step, the tools between frames: the same at each frame
    assert [int(n) for n in number] == [int(n) for n in counted[1:, 2]], (number, counted[:, 2])
    assert np.abs(mass - counted[1:, 1]).max() < 1e-9 * mass[-1], (mass, counted[:, 1])
    print(f"flow: {int(number[-1])} of 75 bodies, {mass[-1]:.6g} kg through the face in {len(rows)} frames, as the host counts them")


def main():
    check_flow()
    check_host_template()
    with_vtk = os.environ["ELLIPSOID_VTK"] == "1"
    simulate("smooth", "smooth", 2, VTK_DUMPS if with_vtk else "")
    simulate("ms", "multisphere", 1, VTK_DUMPS if with_vtk else "")
    for name in "smooth", "ms":
        check_contacts(name)
        check_force_chains(name)
        if with_vtk:
            check_vtk(name)
    if with_vtk:
        check_broken_vtk("ms")


main()
