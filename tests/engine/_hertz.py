"""Hertz's head-on collision in closed form; the equations stand in hertz_collision.py."""

import math


def hertz(mass, radius, modulus, speed):
    """Largest overlap (m) and contact time (s)."""
    overlap = (15.0 * mass * speed ** 2 / (16.0 * modulus * math.sqrt(radius))) ** 0.4
    factor = 2.0 * math.sqrt(math.pi) * math.gamma(1.4) / math.gamma(0.9)
    return overlap, factor * overlap / speed
