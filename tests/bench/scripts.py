"""Input scripts of the benchmarks in space, for every kind of particle. SI units."""

import re
from dataclasses import dataclass
from pathlib import Path

from start import A, B, MASS, MOMENTS, write_superquadrics

LAW = "model hertz/viscous tangential history/viscous"
CLOCK = Path(__file__).parent / "clock.sh"
SIDE = 0.029  # of the periodic base of the bed of 1000 (m)
BOX = 2.0 * SIDE  # of the box with walls (m)
INCLINE = 0.42  # sine of the slope of the flow: 25 degrees


@dataclass(frozen=True)
class Shape:
    """One kind of particle: how the engine is told of it."""

    name: str
    kind: str  # sphere, smooth, multisphere, superquadric or rigid
    subspheres: int = 0

    @property
    def start(self):
        """Which shape's settled bed it starts from."""
        return {"sphere": "sphere", "rigid": f"rigid{self.subspheres}"}.get(self.kind, "smooth")

    @property
    def atom_style(self):
        return {"sphere": "granular", "rigid": "granular", "superquadric": "superquadric"}.get(
            self.kind, "granular/ellipsoid")

    @property
    def contacts(self):
        """Room for simultaneous contacts of one pair of multi-spheres."""
        return 8 if self.subspheres < 10 else 16 if self.subspheres < 30 else 64

    @property
    def pair(self):
        return {"sphere": f"gran {LAW}", "rigid": f"gran {LAW}",
                "superquadric": f"gran {LAW} surface superquadric",
                "smooth": f"gran/ellipsoid {LAW} surface smooth",
                "multisphere": f"gran/ellipsoid {LAW} surface multisphere contacts {self.contacts}"}[self.kind]

    @property
    def wall(self):
        style = "wall/gran/ellipsoid" if self.kind in ("smooth", "multisphere") else "wall/gran"
        surface = {"sphere": "", "rigid": ""}.get(self.kind, f"surface {self.kind}")
        return f"{style} {LAW} {surface}"

    @property
    def motion(self):
        return {"sphere": "fix motion grains nve/sphere",
                "rigid": "fix motion all multisphere",
                "superquadric": "fix motion grains nve/superquadric integration_scheme 1"}.get(
                    self.kind, "fix motion grains nve/ellipsoid")

    @property
    def subsphere_fix(self):
        if self.kind != "multisphere":
            return ""
        return f"fix subspheres all property/atom subspheres scalar yes yes no {self.subspheres}\n"


SPHERE = Shape("sphere", "sphere")
SMOOTH = Shape("smooth", "smooth")
SUPERQUADRIC = Shape("superquadric", "superquadric")


def multisphere(count):
    return Shape(f"multisphere {count}", "multisphere", count)


def rigid(count):
    return Shape(f"rigid {count}", "rigid", count)


def header(shape, boundary):
    return f"""atom_style {shape.atom_style}
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
units si
"""


def forces(shape, damping=100.0, skin=0.001):
    """Contact law, for two atom types of the same material."""
    def table(value):
        return "peratomtypepair 2 " + " ".join([str(value)] * 4)
    return f"""neighbor {skin} bin
neigh_modify delay 0 page 1000000
fix m1 all property/global youngsModulus peratomtype 183e6 183e6
fix m2 all property/global poissonsRatio peratomtype 0.2 0.2
fix m3 all property/global coefficientFriction {table(0.3)}
fix m4 all property/global viscousDampingNormal {table(damping)}
fix m5 all property/global viscousDampingTangential {table(damping)}
pair_style {shape.pair}
pair_coeff * *
"""


#: of the host's laws, per pair of the two types; a cohesion that does not move the bed
HOST_PROPERTIES = {"coefficientRestitution": 0.5, "coefficientRollingFriction": 0.1, "cohesionEnergyDensity": 1e3}


def with_law(script, law):
    """The script of a bed with another contact law for particles and walls."""
    if law == LAW:
        return script
    models, *setting = law.split(" direction ")
    lines = "fix velocity all property/global characteristicVelocity scalar 0.5\n"
    for name, value in HOST_PROPERTIES.items():
        lines += f"fix {name} all property/global {name} peratomtypepair 2 {' '.join([str(value)] * 4)}\n"
    script = script.replace("pair_style", lines + "pair_style", 1).replace(LAW, models)
    if not setting:
        return script
    last = r"^(pair_style .*|fix \w+ all wall/gran.*)$"  # a setting stands after all else
    return re.sub(last, rf"\1 direction {setting[0]}", script, flags=re.MULTILINE)


def timed(steps, warm):
    """Runs `warm` steps, then `steps` between two readings of the clock."""
    return f"""timestep 5e-6
thermo 1000000
thermo_modify lost error norm no
run {warm}
shell sh {CLOCK} clock.txt
run {steps} pre no
shell sh {CLOCK} clock.txt
"""


def gravity(case):
    down = {"flow": f"{INCLINE} 0.0 -{(1.0 - INCLINE ** 2) ** 0.5}"}.get(case, "0.0 0.0 -1.0")
    return f"fix gravity all gravity 9.81 vector {down}\n"


def box_of_planes(shape):
    """Floor and sides of the box, as planes."""
    planes = ("zplane 0.0", "xplane 0.0", f"xplane {BOX}", "yplane 0.0", f"yplane {BOX}")
    return "".join(f"fix wall{k} all {shape.wall} primitive type 1 {plane}\n" for k, plane in enumerate(planes))


def box_of_triangles(shape, mesh):
    return (f"fix cad all mesh/surface file {mesh} type 1\n"
            f"fix box all {shape.wall} mesh n_meshes 1 meshes cad\n")


def moving_bodies(shape, case, start, mesh=None):
    """Script of a bed, a flow, a cloud or a box (of planes or of the triangles of a file) up to its run."""
    boundary = {"cloud": "p p p", "box": "f f f", "mesh": "f f f"}.get(case, "p p f")
    script = header(shape, boundary)
    if shape.kind == "superquadric":
        write_superquadrics(start)
        script += f"read_data {start}.superquadric\ninclude {start}.superquadric.in\n"
    else:
        script += f"read_data {start}\n"
    script += forces(shape) + shape.subsphere_fix + gravity(case)
    script += "group grains type 1\n"
    if case == "flow":
        script += "group base type 2\nneigh_modify exclude group base base\n"
    elif case in ("box", "mesh"):
        script += box_of_triangles(shape, mesh) if mesh else box_of_planes(shape)
    elif case != "cloud":
        settings = f" contacts {shape.contacts}" if shape.kind == "multisphere" else ""
        script += f"fix floor all {shape.wall} primitive type 1 zplane 0.0{settings}\n"
    return script + shape.motion + "\n"


def damped(script):
    """The script with such strong damping that particles come to rest soon."""
    return re.sub(r"^(fix \w+ all property/global viscousDamping\w+ peratomtypepair 2 ).*$", r"\g<1>2e3 2e3 2e3 2e3",
                  script, flags=re.MULTILINE)


def settle(shape, case, start, steps):
    """Script that lets a bed come to rest on the floor, or a flow come into motion; its last frame
    is settled.dump."""
    script = moving_bodies(shape, case, start)
    if case in ("bed", "box"):
        script = damped(script)
    columns = "id type x y z vx vy vz omegax omegay omegaz"
    if shape.kind != "sphere":
        columns += " quat1 quat2 quat3 quat4"
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in columns.split())
    return script + f"""timestep 1e-5
thermo {steps // 10}
thermo_modify lost error norm no
dump end all custom {steps} settled.dump {columns}
dump_modify end sort id format "{form}"
run {steps}
"""


def rigid_bodies(shape, count, chain_file, height, side=SIDE):
    """The host's rigid bodies, put at random into a column of `height` (m) above the floor."""
    i_x, i_y, i_z = MOMENTS
    return header(shape, "p p f") + f"""region box block 0 {side} 0 {side} 0 {height + 0.01} units box
create_box 2 box
""" + forces(shape) + gravity("bed") + f"""fix floor all {shape.wall} primitive type 1 zplane 0.0
fix grain all particletemplate/multisphere 10037 atom_type 1 density constant 1340 &
    nspheres {shape.subspheres} ntry 1000 spheres file {chain_file} scale 1.0 type 1 &
    mass {MASS} inertia_tensor {i_x} 0 0 {i_y} 0 {i_z} use_density
fix mixture all particledistribution/discrete 10039 1 grain 1.0
region column block 0 {side} 0 {side} 0 {height} units box
fix motion all multisphere
fix insert all insert/pack seed 15485863 distributiontemplate mixture maxattempt 500 &
    insert_every once overlapcheck yes all_in no orientation random region column &
    ntry_mc 10000 particles_in_region {count}
"""
