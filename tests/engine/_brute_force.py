"""Forces between ellipsoids, and between chains of spheres or clumps, by brute force: all pairs, all images, every step.

Written for the adversarial tests, from the paper's equations and the definitions of the host's models alone; it shares
no code with the engine, its tools or the other tests, and keeps no list of neighbours. Positions are unwrapped (m);
quaternions are scalar first, body to space; SI units throughout.
"""

import itertools
import math

import numpy as np


def turn(quaternions):
    """Rotation matrices (..., 3, 3), body to space."""
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def sphere_chain(a, b, count):
    """Abscissae and radii of N spheres: eqs. (3) to (8), N = 3 beyond a = 2 b by section 4.2.1."""
    if count == 1:
        return np.zeros(1), np.array([b])
    steps, end = (count - 1) // 2, (a * a - b * b) / a

    def places(first):
        x, way = [0.0, first], first
        while len(x) <= steps:
            old, now = x[-2], x[-1]
            way *= math.sqrt(max(0.0, a * a - now * now) / (a * a - old * old)) if old < a else 0.0
            x.append(now + way)
        return x

    low, high = 0.0, end
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if places(middle)[-1] < end else (low, middle)
    x = np.array(places(low))
    r = b * np.sqrt(np.maximum(0.0, 1.0 - x * x / (a * a - b * b)))
    if count == 3 and x[1] >= r[0] + r[1]:
        x, r = np.array([0.0, 0.5 * (a + b)]), np.array([b, 0.5 * (a - b)])
    return np.concatenate([-x[:0:-1], x]), np.concatenate([r[:0:-1], r])


def _quadratic(matrices, vectors):
    return np.einsum("ni,nij,nj->n", vectors, matrices, vectors)


def _lowest(first, second, way, normal, step):
    """Unit normals along a step, or against it, where s_1(n) + s_2(n) - n.d is least: slender bodies make whole steps
    go astray. Whole ones win ties."""
    length = np.maximum(1.0, np.linalg.norm(step, axis=1) / 0.3)[:, None]
    trials = np.array([normal + share * step / length for share in (1.0, 0.3, 0.1, 0.01, 0.0, -0.1, -0.01)])
    trials /= np.linalg.norm(trials, axis=2)[..., None]
    phi = np.array([np.sqrt(_quadratic(first, n)) + np.sqrt(_quadratic(second, n)) - np.einsum("ni,ni->n", n, way)
                    for n in trials])
    least = phi.min(axis=0)
    near = phi <= least + 1e-15 * np.linalg.norm(way, axis=1)
    return trials[near.argmax(axis=0), np.arange(len(way))]


def smooth_contacts(first, second, way):
    """Overlap (M,), unit normals from first to second, points from the first centre, both Gaussian radii and the
    reduced radius (19), for M pairs of S = R diag(a^2) R^T that are near each other.

    The normal of the contact function of Perram and Wertheim (1985) is the start, Newton's method for the least
    s_1(n) + s_2(n) - n.d follows.
    """
    low, high = np.zeros(len(way)), np.ones(len(way))
    golden = 0.5 * (math.sqrt(5.0) - 1.0)

    def value(s):
        mixed = (1 - s)[:, None, None] * first + s[:, None, None] * second
        return s * (1 - s) * np.einsum("ni,ni->n", way, np.linalg.solve(mixed, way[..., None])[..., 0])

    for _ in range(60):
        left, right = high - golden * (high - low), low + golden * (high - low)
        rises = value(left) < value(right)
        low, high = np.where(rises, left, low), np.where(rises, high, right)
    s = 0.5 * (low + high)
    mixed = (1 - s)[:, None, None] * first + s[:, None, None] * second
    normal = np.linalg.solve(mixed, way[..., None])[..., 0]
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    identity = np.eye(3)
    for _ in range(25):
        radii, gradient, phi = 0.0, -way, -np.einsum("ni,ni->n", normal, way)
        for shape in (first, second):
            support = np.sqrt(_quadratic(shape, normal))
            far = np.einsum("nij,nj->ni", shape, normal) / support[:, None]
            radii = radii + (shape - np.einsum("ni,nj->nij", far, far)) / support[:, None, None]
            gradient, phi = gradient + far, phi + support
        tangential = gradient - phi[:, None] * normal
        hessian = radii - phi[:, None, None] * identity
        outer = np.einsum("ni,nj->nij", normal, normal)
        project = identity - outer
        bordered = project @ hessian @ project + np.linalg.norm(hessian, axis=(1, 2))[:, None, None] * outer
        step = -np.linalg.solve(bordered, tangential[..., None])[..., 0]
        normal = _lowest(first, second, way, normal, step)
    supports, points, gauss, inverse = [], [], [], 0.0
    for shape in (first, second):
        support = np.sqrt(_quadratic(shape, normal))
        far = np.einsum("nij,nj->ni", shape, normal) / support[:, None]
        radii = (shape - np.einsum("ni,nj->nij", far, far)) / support[:, None, None]
        outer = np.einsum("ni,nj->nij", normal, normal)
        curvature = np.linalg.inv(radii + outer) - outer  # 0 along the normal
        inverse = inverse + curvature
        gauss.append(1.0 / np.sqrt(np.linalg.det(curvature + outer)))
        supports.append(support)
        points.append(far)
    overlap = supports[0] + supports[1] - np.einsum("ni,ni->n", normal, way)
    middle = 0.5 * (points[0] + way - points[1])
    outer = np.einsum("ni,nj->nij", normal, normal)
    reduced = 1.0 / np.sqrt(np.linalg.det(inverse + outer))  # 2 sqrt(A B) of (19) squared
    return overlap, normal, middle, gauss[0], gauss[1], reduced


class Law:
    """Eqs. (23) and (24). `material`: (E, nu) of each type; the others [type][type]."""

    def __init__(self, material, friction, damping_normal, damping_tangential, time_step,
                 direction="displacement", limit_force=False):
        self.material, self.friction = material, friction
        self.eta_n, self.eta_t, self.dt = damping_normal, damping_tangential, time_step
        self.direction, self.limit_force = direction, limit_force

    def moduli(self, types):
        """Of the normal and of the tangential force, of a pair of types."""
        (e_i, nu_i), (e_j, nu_j) = (self.material[t] for t in types)
        return (1.0 / ((1 - nu_i ** 2) / e_i + (1 - nu_j ** 2) / e_j),
                1.0 / (2 * (2 - nu_i) * (1 + nu_i) / e_i + 2 * (2 - nu_j) * (1 + nu_j) / e_j))

    def stiffnesses(self, types, overlap, radius):
        """F_n / h of the elastic normal force, k_t."""
        normal, shear = self.moduli(types)
        return 4.0 / 3.0 * normal * math.sqrt(radius * overlap), 16.0 / 3.0 * shear * math.sqrt(radius * overlap)

    def dampings(self, types, mass, overlap, radius):
        i, j = types
        return self.eta_n[i][j] * mass, self.eta_t[i][j] * mass

    def normal_force(self, types, mass, contact, along):
        """`along`: velocity of the first relative to the second, away from it."""
        overlap, _, radius = contact
        elastic = self.stiffnesses(types, overlap, radius)[0] * overlap
        found = elastic - self.dampings(types, mass, overlap, radius)[0] * along
        return max(0.0, found) if self.limit_force else found

    def force(self, types, mass, contact, velocity, spring, advance):
        """Force on the first body, the normal one alone, and the new spring. `velocity`: of the first relative to the
        second at the contact; `contact`: (overlap, normal from first to second, reduced radius)."""
        away = -contact[1]
        along = velocity @ away
        normal_force = self.normal_force(types, mass, contact, along)
        k = self.stiffnesses(types, contact[0], contact[2])[1]
        damping = self.dampings(types, mass, contact[0], contact[2])[1]
        limit = self.friction[types[0]][types[1]] * abs(normal_force)
        tangential, spring = self.friction_force(k, damping, limit, velocity - along * away, away, spring, advance)
        return normal_force * away + tangential, normal_force, spring

    def friction_force(self, k, damping, limit, slip, away, spring, advance):
        if advance:
            length = np.linalg.norm(spring)
            flat = spring - (spring @ away) * away
            rest = np.linalg.norm(flat)
            spring = (flat * (length / rest) if rest > 0.0 else flat) + self.dt * slip
        trial = -k * spring - damping * slip
        size = np.linalg.norm(trial)
        if self.direction == "velocity":
            elastic, speed = k * np.linalg.norm(spring), np.linalg.norm(slip)
            if elastic > limit and advance:
                spring = spring * (limit / elastic)
            return -min(size, limit) / speed * slip if speed > 0.0 else 0.0 * slip, spring
        if size > limit:
            tangential = trial * (limit / size)
            if advance and k > 0.0:
                spring = -(tangential + damping * slip) / k
            return tangential, spring
        return trial, spring


class HostLaw(Law):
    """The host's `model hertz tangential history`: `restitution` [type][type] in place of both dampings."""

    def __init__(self, material, friction, restitution, time_step, limit_force=False):
        super().__init__(material, friction, None, None, time_step, limit_force=limit_force)
        self.restitution = restitution

    def dampings(self, types, mass, overlap, radius):
        logarithm = math.log(self.restitution[types[0]][types[1]])
        beta = -logarithm / math.hypot(logarithm, math.pi)
        kn, kt = self.stiffnesses(types, overlap, radius)
        return tuple(2.0 * math.sqrt(5.0 / 6.0) * beta * math.sqrt(s * mass) for s in (1.5 * kn, kt))

    def stiffnesses(self, types, overlap, radius):
        normal, shear = self.moduli(types)
        return 4.0 / 3.0 * normal * math.sqrt(radius * overlap), 8.0 * shear * math.sqrt(radius * overlap)

    def friction_force(self, k, damping, limit, slip, away, spring, advance):
        if advance:
            spring = spring + self.dt * slip
            spring = spring - (spring @ away) * away
        elastic = k * np.linalg.norm(spring)
        if elastic > limit:
            tangential = -k * spring * (limit / elastic)
            return tangential, -tangential / k if advance else spring
        return -k * spring - damping * slip, spring


class Rolling:
    """`rolling_friction cdt` or `epsd2`; `coefficient` [type][type]."""

    def __init__(self, kind, coefficient):
        self.kind, self.coefficient = kind, coefficient

    def couple(self, law, types, contact, normal_force, rate, memory, advance):
        """Couple on the first body and what is remembered of it; `rate`: its angular velocity relative to the second."""
        overlap, n, radius = contact
        kn, kt = law.stiffnesses(types, overlap, radius)
        mu, speed = self.coefficient[types[0]][types[1]], np.linalg.norm(rate)
        if self.kind == "cdt":
            strength = mu * kn * overlap * radius
            resisted = strength / speed * rate if speed > 0.0 else 0.0 * rate
            return -(resisted - (resisted @ n) * n), memory
        trial = memory + law.dt * kt * radius ** 2 * (rate - (rate @ n) * n)
        size, limit = np.linalg.norm(trial), abs(normal_force) * radius * mu
        if size > limit:
            trial = trial * (limit / size)
        return -trial, trial if advance else memory


class Cohesion:
    """`cohesion sjkr`: an energy density [type][type] times the circle in which two spheres intersect."""

    def __init__(self, density):
        self.density = density

    def pull(self, types, overlap, radius, local):
        """`local`: radii of two spheres that make the same contact, or None at a plane."""
        if local is None:
            area = math.pi * (radius ** 2 - (radius - overlap) ** 2)
        else:
            i, j = local
            d = i + j - overlap
            area = 0.25 * math.pi * overlap * (2 * i - overlap) * (2 * j - overlap) * (2 * (i + j) - overlap) / d ** 2
        return self.density[types[0]][types[1]] * area


class Frame:
    """Bodies at one moment, ordered by id. `chains[k]`: number of spheres, 0 for a smooth body; `clumps[k]`: number of
    the clump (BruteForce.clumps), 0 where it is none."""

    def __init__(self, ids, types, mass, moments, axes, x, v, omega, quaternion, chains, clumps=None):
        self.clumps = np.zeros(len(ids), int) if clumps is None else clumps
        self.ids, self.types, self.mass, self.moments, self.axes = ids, types, mass, moments, axes
        self.x, self.v, self.omega, self.quaternion, self.chains = x, v, omega, quaternion, chains
        self.turn = turn(quaternion)

    def spin(self):
        """Angular momentum in space (N, 3)."""
        body = np.einsum("nji,nj->ni", self.turn, self.omega)
        return np.einsum("nij,nj->ni", self.turn, self.moments * body)

    def omega_of(self, spin):
        body = np.einsum("nji,nj->ni", self.turn, spin) / self.moments
        return np.einsum("nij,nj->ni", self.turn, body)

    def kinetic_energy(self):
        return 0.5 * float((self.mass * (self.v ** 2).sum(1)).sum())

    def rotational_energy(self):
        return 0.5 * float((self.spin() * self.omega).sum())


class Plane:
    """A wall: `normal` points from the bodies into it; `place(time)` a point, `velocity` of its surface. One that turns
    gives functions: `normal(time)`, `velocity(point, time)`."""

    def __init__(self, normal, place, velocity=(0.0, 0.0, 0.0), type=0):
        self._normal, self.place, self._velocity = normal, place, velocity
        self.type = type

    def normal(self, time):
        return np.array(self._normal(time) if callable(self._normal) else self._normal, float)

    def velocity(self, point, time):
        return np.array(self._velocity(point, time) if callable(self._velocity) else self._velocity, float)


class BruteForce:
    """Keeps the friction springs and rolling couples from step to step; nothing else.

    `periods`: lengths of the box, infinite where it is not periodic; `tilt`: xy, xz, yz of a triclinic one; `average`:
    several contacts of a pair share a weight of 1; `clumps`: {number: (centres (n, 3) in the body's frame, radii (n,))}
    of bodies of any size, which their second semi-axis tells.
    """

    def __init__(self, law, periods, walls=(), average=False, tilt=(0.0, 0.0, 0.0), rolling=None, cohesion=None,
                 clumps=None):
        self.law, self.walls, self.average, self.rolling, self.cohesion = law, walls, average, rolling, cohesion
        self.periods = np.array(periods, float)  # infinite: not periodic
        self.is_periodic = np.isfinite(self.periods)
        xy, xz, yz = tilt
        x, y, z = np.where(self.is_periodic, self.periods, 1.0)
        self.cell = np.array([[x, 0.0, 0.0], [xy, y, 0.0], [xz, yz, z]])  # its rows: the edges
        self.edge_rates = np.zeros((3, 3))  # of the cell, by which images are faster (m/s)
        self.springs, self.couples = {}, {}
        self.chains, self.clumps = {}, clumps or {}

    def nearest(self, way):
        """`way` (..., 3) as whole numbers of edges, 0 where the box is not periodic."""
        return np.where(self.is_periodic, np.round(way @ np.linalg.inv(self.cell)), 0.0)

    def spheres(self, frame, k):
        """Centres (n, 3) from the body's own, in space, and radii."""
        if frame.clumps[k]:
            centres, radii = self.clumps[frame.clumps[k]]
            scale = frame.axes[k][1] / (np.abs(centres[:, 1]) + radii).max()
            return scale * centres @ frame.turn[k].T, scale * radii
        key = (frame.axes[k][0], frame.axes[k][1], frame.chains[k])
        if key not in self.chains:
            self.chains[key] = sphere_chain(*key)
        x, r = self.chains[key]
        return np.outer(x, frame.turn[k][:, 0]), r

    def near_pairs(self, frame):
        """(i, j, image, way): all pairs and all images whose bounding spheres overlap; a body and its own image
        once."""
        reach = np.where(frame.clumps > 0, np.linalg.norm(frame.axes, axis=1), frame.axes.max(1)) * 1.001
        i, j = np.triu_indices(len(frame.ids))
        base = frame.x[j] - frame.x[i]
        around = np.array(list(itertools.product(*[range(-2, 3) if f else (0,) for f in self.is_periodic])))
        image = (around[None, :, :] - self.nearest(base)[:, None, :]).astype(int)
        way = base[:, None, :] + image @ self.cell
        near = (way ** 2).sum(2) < (reach[i] + reach[j])[:, None] ** 2
        return [(i[p], j[p], tuple(image[p, m]), way[p, m]) for p, m in np.argwhere(near)
                if i[p] != j[p] or tuple(image[p, m]) > (0, 0, 0)]

    def contacts(self, frame):
        """{(id i, id j, image, sphere, sphere): (i, j, way, overlap, normal, point, reduced radius, weight, local radii)}."""
        near, found = self.near_pairs(frame), {}
        smooth = [p for p in near if frame.chains[p[0]] == 0]
        if smooth:
            shapes = np.einsum("nij,nj,nkj->nik", frame.turn, frame.axes ** 2, frame.turn)
            i, j = np.array([p[0] for p in smooth]), np.array([p[1] for p in smooth])
            overlap, normal, point, gauss_i, gauss_j, radius = smooth_contacts(shapes[i], shapes[j],
                                                                               np.array([p[3] for p in smooth]))
            share = radius * (gauss_i + gauss_j) / (gauss_i * gauss_j)
            for k in np.flatnonzero(overlap > 0.0):
                a, b, image, way = smooth[k]
                found[frame.ids[a], frame.ids[b], image, -1, -1] = (
                    a, b, way, overlap[k], normal[k], point[k], radius[k], 1.0,
                    (share[k] * gauss_i[k], share[k] * gauss_j[k]))
        for a, b, image, way in near:
            if frame.chains[a] == 0:
                continue
            (c, r), (d, s) = self.spheres(frame, a), self.spheres(frame, b)
            between = way + d[None, :, :] - c[:, None, :]
            length = np.linalg.norm(between, axis=2)
            touching = np.argwhere(length < r[:, None] + s[None, :])
            weight = 1.0 / len(touching) if self.average and len(touching) else 1.0
            for p, q in touching:
                n, h = between[p, q] / length[p, q], r[p] + s[q] - length[p, q]
                found[frame.ids[a], frame.ids[b], image, int(p), int(q)] = (
                    a, b, way, h, n, c[p] + (r[p] - 0.5 * h) * n, r[p] * s[q] / (r[p] + s[q]), weight, (r[p], s[q]))
        return found

    def wall_contacts(self, frame, time):
        """{(id, number of the wall, sphere): (k, wall, overlap, point, radius, weight)}."""
        found = {}
        for number, wall in enumerate(self.walls):
            n, place = wall.normal(time), np.array(wall.place(time))
            for k in range(len(frame.ids)):
                distance = (place - frame.x[k]) @ n
                if frame.chains[k] == 0:
                    shape = frame.turn[k] @ np.diag(frame.axes[k] ** 2) @ frame.turn[k].T
                    support = math.sqrt(n @ shape @ n)
                    h = support - distance
                    if h > 0.0:
                        radius = frame.axes[k].prod() / support ** 2
                        found[frame.ids[k], number, -1] = (k, wall, h, shape @ n / support - 0.5 * h * n, radius, 1.0)
                    continue
                c, r = self.spheres(frame, k)
                touching = np.flatnonzero(c @ n + r > distance)
                weight = 1.0 / len(touching) if self.average and len(touching) else 1.0
                for p in touching:
                    h = c[p] @ n + r[p] - distance
                    found[frame.ids[k], number, int(p)] = (k, wall, h, c[p] + (r[p] - 0.5 * h) * n, r[p], weight)
        return found

    def step(self, frame, time, v, omega, advance, wall_moves=True):
        """Forces (N, 3), torques, contact list {key: (overlap, normal, point in space, force)}, virial (3, 3) of
        the contacts between bodies. `v`, `omega`: at the moment of the forces; `advance`: springs grow."""
        force, torque, virial = np.zeros_like(frame.x), np.zeros_like(frame.x), np.zeros((3, 3))
        springs, couples, rows = {}, {}, {}

        def apply(key, types, mass, contact, relative, rate, local):
            """Force and couple on the first body."""
            f, normal_force, springs[key] = self.law.force(types, mass, contact, relative,
                                                           self.springs.get(key, np.zeros(3)), advance)
            couple = np.zeros(3)
            if self.rolling:
                couple, couples[key] = self.rolling.couple(self.law, types, contact, normal_force, rate,
                                                           self.couples.get(key, np.zeros(3)), advance)
            if self.cohesion:
                f = f + self.cohesion.pull(types, contact[0], contact[2], local) * contact[1]
            return f, couple

        for key, (i, j, way, h, n, point, radius, weight, local) in self.contacts(frame).items():
            at_j = point - way
            relative = (v[i] + np.cross(omega[i], point) - v[j] - np.cross(omega[j], at_j)
                        - np.array(key[2]) @ self.edge_rates)
            mass = frame.mass[i] * frame.mass[j] / (frame.mass[i] + frame.mass[j])
            f, couple = apply(key, (frame.types[i], frame.types[j]), mass, (h, n, radius), relative,
                              omega[i] - omega[j], local)
            f, couple = weight * f, weight * couple
            force[i] += f
            force[j] -= f
            torque[i] += np.cross(point, f) + couple
            torque[j] -= np.cross(at_j, f) + couple
            virial += np.outer(-way, f)
            rows[key] = (h, n, frame.x[i] + point, f)
        for key, (k, wall, h, point, radius, weight) in self.wall_contacts(frame, time).items():
            n = wall.normal(time)
            foot = frame.x[k] + point - 0.5 * h * n
            relative = v[k] + np.cross(omega[k], point) - (wall.velocity(foot, time) if wall_moves else 0.0)
            f, couple = apply(key, (frame.types[k], wall.type), frame.mass[k], (h, n, radius), relative, omega[k], None)
            force[k] += weight * f
            torque[k] += np.cross(point, weight * f) + weight * couple
        if advance:
            self.springs, self.couples = springs, couples
        return force, torque, rows, virial


#: Of dumps that replay() reads, with all digits.
REPLAYED = ("id type mass xu yu zu vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez "
            "fx fy fz tqx tqy tqz").split()


def replay(brute, frames, time_step, spheres=0):
    """Forces (N, 3), torques and contact list of each frame (F, N, columns of REPLAYED) of a run that was dumped every step,
    by brute force, from the positions of the dump. `spheres`: of each body; 0: smooth. Walls move from the first step on."""
    before = None
    for k, values in enumerate(frames):
        axes, mass = values[:, 16:19], values[:, 2]
        square = axes ** 2
        frame = Frame(values[:, 0].astype(int), np.zeros(len(values), int), mass,
                      0.2 * mass[:, None] * (square.sum(1)[:, None] - square), axes, values[:, 3:6], values[:, 6:9],
                      values[:, 9:12], values[:, 12:16], np.full(len(values), spheres))
        v, omega = frame.v, frame.omega
        if k > 0:
            old, f, t = before
            v = old.v + 0.5 * time_step * f / old.mass[:, None]
            omega = frame.omega_of(old.spin() + 0.5 * time_step * t)
        force, torque, rows, _ = brute.step(frame, k * time_step, v, omega, advance=k > 0, wall_moves=k > 0)
        yield force, torque, rows
        before = frame, values[:, 19:22], values[:, 22:25]
