"""A triaxial body that lies on a plane while gravity is tilted: flat side down, at the pitch at which
the contact point is straight below the centre."""

import math
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, run

GRAVITY = 9.81
AXES = (3e-3, 1.2e-3, 2e-3)
RADIUS = AXES[0] * AXES[2] / AXES[1]  # Gaussian radius of curvature of the flat side


def resting_body(angle):
    """Body whose weight, tilted by `angle` (rad) against the plane y = 0, acts through the contact."""
    a, b, _ = AXES

    def tilt(alpha):  # between the plane's normal and the line from the contact to the centre
        return alpha - math.atan(math.tan(alpha) * b * b / (a * a))

    low, high = 0.0, 1.0
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if tilt(middle) < angle else (low, middle)
    beta = math.atan(math.tan(low) * b * b / (a * a))
    height = math.hypot(a * math.sin(beta), b * math.cos(beta))
    body = Particle((0.0, height, 0.0), AXES, quaternion_of((0, 0, 1), beta))
    # pressed in by its weight, eq. 23
    modulus = 183e6 / (2.0 * (1.0 - 0.2 ** 2))
    load = body.mass * GRAVITY * math.cos(angle)
    overlap = (0.75 * load / (modulus * math.sqrt(RADIUS))) ** (2.0 / 3.0)
    body.position = (0.0, height - overlap, 0.0)
    return body


def slide(name, slope, friction, time, time_step, direction="displacement", frames=600):
    """Times (F,), way down the slope (F,), speed (F,) of the body on a slope tan(angle)."""
    angle = math.atan(slope)
    setup = Setup(friction=friction, time_step=time_step, box=(-0.5, 0.1, -0.01, 0.05, -0.01, 0.01),
                  pair=f"gran/ellipsoid {LAW} surface smooth direction {direction}")
    steps = round(time / time_step)
    script = setup.with_particles([resting_body(angle)], f"{name}.data")
    script += (f"fix g all gravity {GRAVITY} vector {-math.sin(angle)!r} {-math.cos(angle)!r} 0.0\n"
               f"fix floor all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 yplane 0.0 "
               f"direction {direction}\nfix motion all nve/ellipsoid planar yes\n")
    script += dump(f"{name}.dump", max(1, steps // frames)) + f"run {steps}\n"
    run(script, name=f"in.{name}")
    at, columns = read_dump(Path(f"{name}.dump"))
    return at * time_step, -columns["x"][:, 0], -columns["vx"][:, 0]


def settled_speed(times, way):
    """Mean speed between the second and the last third of a run (m/s). The body rocks about its
    contact without end (rolling has no resistance): weighted means take that out."""
    third = len(times) // 3
    weights = np.hanning(third)
    weights /= weights.sum()
    later, earlier = slice(2 * third, 3 * third), slice(third, 2 * third)
    return float(weights @ (way[later] - way[earlier]) / (times[2 * third] - times[third]))
