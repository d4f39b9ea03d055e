"""What the engine tests share: scripts put together, the engine run, its dumps read.

SI units throughout. A particle is a `Particle`; quaternions are scalar first, body to space.
"""

import functools
import math
import os
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parent.parent))  # benchmarks use this file as well
import _plain_numbers  # noqa: E402, F401

LIGGGHTS = Path(os.environ["ELLIPSOID_BIN"]) / "liggghts"
COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz "
           "quat1 quat2 quat3 quat4 shapex shapey shapez").split()
SPHERE_COLUMNS = COLUMNS[:18]
SLOWNESS = int(os.environ.get("ELLIPSOID_SLOWNESS", "1"))  # of this build; 1: optimised
LAW = "model hertz/viscous tangential history/viscous"


@functools.cache
def host_is_inl():
    """Is the engine built with LIGGGHTS-INL?"""
    told = subprocess.run([LIGGGHTS, "--version"], capture_output=True, text=True, check=True).stdout
    return "LIGGGHTS-INL" in told


def rigid_bodies():
    """Script lines of the host's rigid bodies of spheres, moved by Richardson's scheme.

    LIGGGHTS-INL's fix multisphere moves nothing by itself; its fix nve/nonspherical has this scheme as
    number 0.
    """
    motion = "fix turn all nve/nonspherical integration_scheme 0\n" if host_is_inl() else ""
    return "fix bodies all multisphere\n" + motion


@dataclass
class Material:
    """Properties of one atom type; `friction` and the dampings hold for all type pairs."""

    youngs_modulus: float = 183e6
    poissons_ratio: float = 0.2


@dataclass
class Particle:
    """One ellipsoid; mass (kg) of the density 1340 kg/m3 and moments of a homogeneous body unless
    given."""

    position: tuple
    semiaxes: tuple
    quaternion: tuple = (1.0, 0.0, 0.0, 0.0)
    velocity: tuple = (0.0, 0.0, 0.0)
    omega: tuple = (0.0, 0.0, 0.0)
    mass: float = 0.0
    moments: tuple = ()
    type: int = 1

    def __post_init__(self):
        a, b, c = self.semiaxes
        if not self.mass:
            self.mass = 1340.0 * 4.0 / 3.0 * math.pi * a * b * c
        if not self.moments:
            self.moments = tuple(
                0.2 * self.mass * s for s in (b * b + c * c, a * a + c * c, a * a + b * b))

    @property
    def inertia(self):
        """Tensor of inertia in the space frame (3, 3), kg m2."""
        r = rotation(self.quaternion)
        return r @ np.diag(self.moments) @ r.T


@dataclass
class Setup:
    """Head of an input script. `boundary` is the host's three letters."""

    box: tuple = (-0.05, 0.05, -0.05, 0.05, -0.05, 0.05)
    boundary: str = "f f f"
    materials: list = field(default_factory=lambda: [Material()])
    friction: float = 0.3
    damping_normal: float = 100.0
    damping_tangential: float = 100.0
    restitution: float = 0.5  # of the host's own laws only
    pair: str = f"gran/ellipsoid {LAW} surface smooth"
    atom_style: str = "granular/ellipsoid"
    time_step: float = 1e-6
    skin: float = 0.002

    def header(self):
        return f"""
atom_style      {self.atom_style}
atom_modify     map array
boundary        {self.boundary}
newton          off
communicate     single vel yes
units           si
"""

    def properties(self):
        count = len(self.materials)

        def table(value):
            return f"peratomtypepair {count} " + " ".join([repr(value)] * count * count)

        moduli = " ".join(repr(m.youngs_modulus) for m in self.materials)
        ratios = " ".join(repr(m.poissons_ratio) for m in self.materials)
        return f"""
neighbor        {self.skin} bin
neigh_modify    delay 0
fix m1 all property/global youngsModulus peratomtype {moduli}
fix m2 all property/global poissonsRatio peratomtype {ratios}
fix m3 all property/global coefficientFriction {table(self.friction)}
fix m4 all property/global viscousDampingNormal {table(self.damping_normal)}
fix m5 all property/global viscousDampingTangential {table(self.damping_tangential)}
fix m6 all property/global coefficientRestitution {table(self.restitution)}
pair_style      {self.pair}
pair_coeff      * *
timestep        {self.time_step!r}
"""

    def create_box(self):
        bounds = " ".join(repr(b) for b in self.box)
        return f"region box block {bounds} units box\ncreate_box {len(self.materials)} box\n"

    def with_particles(self, particles, file="particles.data"):
        """Script up to the time step, with the particles read from `file`, which is written."""
        rows = spheres_data if self.atom_style == "sphere" else ellipsoids_data
        Path(file).write_text(rows(particles, self.box, len(self.materials)))
        return self.header() + f"read_data {file}\n" + self.properties()

    def without_particles(self):
        return self.header() + self.create_box() + self.properties()


def _data_file(particles, box, types, atom_rows):
    limits = "\n".join(f"{box[2 * k]!r} {box[2 * k + 1]!r} {n}lo {n}hi" for k, n in enumerate("xyz"))
    velocities = "\n".join(
        f"{i} " + " ".join(repr(float(v)) for v in (*p.velocity, *p.omega))
        for i, p in enumerate(particles, 1))
    return (f"particles\n\n{len(particles)} atoms\n{types} atom types\n\n{limits}\n\nAtoms\n\n"
            + "\n".join(atom_rows) + f"\n\nVelocities\n\n{velocities}\n")


def ellipsoids_data(particles, box, types):
    """Text of a data file of atom_style granular/ellipsoid."""
    return _data_file(particles, box, types, [
        f"{i} {p.type} " + " ".join(
            repr(float(v)) for v in (*p.position, *p.semiaxes, *p.quaternion, p.mass, *p.moments))
        for i, p in enumerate(particles, 1)])


def spheres_data(particles, box, types):
    """Text of a data file of atom_style sphere: only the first semi-axis counts."""
    def density(p):
        return p.mass / (4.0 / 3.0 * math.pi * p.semiaxes[0] ** 3)
    return _data_file(particles, box, types, [
        f"{i} {p.type} {2.0 * p.semiaxes[0]!r} {density(p)!r} "
        + " ".join(repr(float(x)) for x in p.position) for i, p in enumerate(particles, 1)])


def dump(file, every=1, columns=COLUMNS):
    """Script lines of a text dump with all digits."""
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in columns)
    return (f"dump d all custom {every} {file} {' '.join(columns)}\n"
            f'dump_modify d sort id format "{form}"\n')


@dataclass
class Outcome:
    code: int
    text: str  # standard output and error


def run(script, ranks=1, timeout=300, check=True, name="in.run"):
    """Run the engine on `script` in the present folder; raises on failure when `check`."""
    Path(name).write_text(script)
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [str(LIGGGHTS), "-in", name, "-log", f"log.{name}"]
    done = subprocess.run(command, capture_output=True, text=True, errors="backslashreplace",
                          timeout=timeout * SLOWNESS)
    outcome = Outcome(done.returncode, done.stdout + done.stderr)
    if check and outcome.code != 0:
        raise AssertionError(f"the engine failed on {name}:\n{outcome.text[-3000:]}")
    return outcome


def run_example(name, variables, ranks=1, timeout=300):
    """Run inputs/NAME.in with some variables given, in the present folder."""
    file = Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs" / f"{name}.in"
    lines = "".join(f"variable {n} index {v}\n" for n, v in variables.items())
    return run(lines + f"include {file}\n", ranks, timeout, name=f"in.{variables['out']}")


def read_dump(file):
    """Frames of a text dump: (steps (F,), {column: (F, N)}); every frame has the same particles."""
    steps, frames, names = [], [], []
    lines = Path(file).read_text().splitlines()
    at = 0
    while at < len(lines):
        steps.append(int(lines[at + 1]))
        count = int(lines[at + 3])
        names = lines[at + 8].split()[2:]
        frames.append([[float(t) for t in line.split()] for line in lines[at + 9:at + 9 + count]])
        at += 9 + count
    values = np.array(frames)
    return np.array(steps), {n: values[:, :, k] for k, n in enumerate(names)}


def vectors(columns, *names):
    """Columns as one array of vectors (..., len(names))."""
    return np.stack([columns[n] for n in names], axis=-1)


def thermo(log, columns=None):
    """Rows of all thermo tables of a log file, or of those with this number of columns."""
    rows = []
    for line in Path(log).read_text().splitlines():
        try:
            row = [float(t) for t in line.split()]
        except ValueError:
            continue
        if len(row) == columns or (columns is None and len(row) > 1):
            rows.append(row)
    return np.array(rows)


def quaternion_of(axis, angle):
    """Unit quaternion of a turn by `angle` (rad) about `axis`."""
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    return (math.cos(0.5 * angle), *(math.sin(0.5 * angle) * axis))


def rotation(q):
    """Rotation matrix (3, 3), body to space, of a unit quaternion."""
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def kinetic_energy(frame_columns):
    """Translation and rotation of all particles per frame (F,), J; moments of homogeneous bodies."""
    c = frame_columns
    velocity = vectors(c, "vx", "vy", "vz")
    spin = vectors(c, "omegax", "omegay", "omegaz")
    axes = vectors(c, "shapex", "shapey", "shapez")
    w, x, y, z = (c[f"quat{k}"] for k in (1, 2, 3, 4))
    r = np.moveaxis(rotation((w, x, y, z)), (0, 1), (-2, -1))
    body = np.einsum("...ji,...j->...i", r, spin)
    squares = axes ** 2
    moments = 0.2 * c["mass"][..., None] * (squares.sum(-1, keepdims=True) - squares)
    return 0.5 * (c["mass"] * (velocity ** 2).sum(-1) + (moments * body ** 2).sum(-1)).sum(-1)
