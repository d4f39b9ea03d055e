"""Three bodies that move and spin apart from each other, for tests of what commands of the host do to
particles; values of particles by name, tensors of inertia, quaternion products in NumPy."""

import numpy as np

from _engine import Particle, Setup, quaternion_of, rotation, run

AXES = [(2.7e-3, 1.9e-3, 1.1e-3), (1.0e-3, 1.8e-3, 2.2e-3), (1.2e-3, 2.4e-3, 2.4e-3)]
COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz angmomx angmomy angmomz quat1 quat2 quat3 "
           "quat4 inertiax inertiay inertiaz density fx fy fz tqx tqy tqz").split()
MOTION = "fix motion all nve/ellipsoid\n"


def bodies():
    """Three triaxial or oblate bodies, apart from each other, turned, moving and spinning."""
    random = np.random.default_rng(14)
    return [Particle(tuple(0.012 * (k - 1) + random.uniform(-1e-3, 1e-3, 3)), axes,
                     quaternion_of(random.normal(size=3), random.uniform(0.3, 3.0)),
                     tuple(random.normal(0.0, 0.1, 3)), tuple(random.normal(0.0, 20.0, 3)))
            for k, axes in enumerate(AXES)]


def write_dump(name, more=()):
    """Script line that writes all columns of the present time step."""
    columns = [*COLUMNS, *more]
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in columns)
    return f'write_dump all custom {name}.dump {" ".join(columns)} modify sort id format "{form}"\n'


def read_columns(name, more=()):
    return dict(zip([*COLUMNS, *more], np.loadtxt(f"{name}.dump", skiprows=9, ndmin=2).T))


def after(commands, name, steps=0, ranks=1, particles=None, more=()):
    """Columns (N,) of all particles after the commands and a run, by name."""
    script = (Setup(time_step=1e-6).with_particles(particles or bodies(), f"{name}.data") + MOTION
              + f"{commands}\nrun {steps}\n{write_dump(name, more)}")
    run(script, ranks, name=f"in.{name}")
    return read_columns(name, more)


def vectors(c, *names):
    return np.stack([c[n] for n in names], axis=-1)


def quaternions(c):
    return vectors(c, "quat1", "quat2", "quat3", "quat4")


def omegas(c):
    return vectors(c, "omegax", "omegay", "omegaz")


def momenta(c):
    return vectors(c, "angmomx", "angmomy", "angmomz")


def tensors(c):
    """Tensors of inertia (N, 3, 3) in the space frame."""
    rotations = np.array([rotation(q) for q in quaternions(c)])
    moments = vectors(c, "inertiax", "inertiay", "inertiaz")
    return np.einsum("nij,nj,nkj->nik", rotations, moments, rotations)


def turned(turn, q):
    """Hamilton product turn * q of quaternions, scalar first."""
    a, u, b, v = turn[0], np.array(turn[1:]), q[0], np.array(q[1:])
    return np.array([a * b - u @ v, *(a * v + b * u + np.cross(u, v))])
