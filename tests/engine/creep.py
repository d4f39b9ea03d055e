"""Tangential spring of eq. (24): `direction displacement` holds a resting body for good; with
`direction velocity` it creeps, the faster the larger the time step. A body on a slope of 0.2 under a
friction coefficient of 0.3, as everywhere in a resting pile."""

import unittest

from _incline import settled_speed, slide

SLOPE, FRICTION, TIME = 0.2, 0.3, 0.9
STEPS = (2e-6, 4e-6, 8e-6)


class Creep(unittest.TestCase):
    def speeds(self, direction):
        found = []
        for step in STEPS:
            times, way, _ = slide(f"{direction}_{step:g}", SLOPE, FRICTION, TIME, step, direction)
            found.append(settled_speed(times, way))
        print(f"direction {direction}: " + ", ".join(
            f"{speed:.3e} m/s at dt = {step:g} s" for speed, step in zip(found, STEPS)))
        return found

    def test_displacement_does_not_creep(self):
        # a ten-millionth of a semi-axis per second, five orders below the creep of the other
        for speed in self.speeds("displacement"):
            self.assertLess(abs(speed), 1e-10)

    def test_velocity_creeps_the_faster_the_larger_the_time_step(self):
        slow, middle, fast = self.speeds("velocity")
        self.assertGreater(slow, 1e-8)
        self.assertGreater(middle, 1.3 * slow)
        self.assertGreater(fast, 1.3 * middle)


if __name__ == "__main__":
    unittest.main(verbosity=2)
