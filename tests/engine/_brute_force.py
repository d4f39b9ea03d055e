"""Forces between ellipsoids, and between chains of spheres, by brute force: all pairs, all images, every step.

Written for the adversarial tests, from the paper's equations alone; it shares no code with the engine, its tools
or the other tests, and keeps no list of neighbours. Positions are unwrapped (m); quaternions are scalar first,
body to space; SI units throughout.
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

    def force(self, types, mass, contact, velocity, spring, advance):
        """Force on the first body and the new spring. `velocity`: of the first relative to the second at the
        contact; `contact`: (overlap, normal from first to second, reduced radius)."""
        overlap, normal, radius = contact
        away = -normal
        (e_i, nu_i), (e_j, nu_j) = (self.material[t] for t in types)
        i, j = types
        stiff = 1.0 / ((1 - nu_i ** 2) / e_i + (1 - nu_j ** 2) / e_j)
        shear = 1.0 / (2 * (2 - nu_i) * (1 + nu_i) / e_i + 2 * (2 - nu_j) * (1 + nu_j) / e_j)
        along = velocity @ away
        slip = velocity - along * away
        normal_force = 4.0 / 3.0 * stiff * math.sqrt(radius * overlap ** 3) - self.eta_n[i][j] * mass * along
        if self.limit_force:
            normal_force = max(0.0, normal_force)
        if advance:
            length = np.linalg.norm(spring)
            flat = spring - (spring @ away) * away
            rest = np.linalg.norm(flat)
            spring = (flat * (length / rest) if rest > 0.0 else flat) + self.dt * slip
        k = 16.0 / 3.0 * shear * math.sqrt(radius * overlap)
        damping = self.eta_t[i][j] * mass
        trial = -k * spring - damping * slip
        size, limit = np.linalg.norm(trial), self.friction[i][j] * abs(normal_force)
        if self.direction == "velocity":
            elastic, speed = k * np.linalg.norm(spring), np.linalg.norm(slip)
            if elastic > limit and advance:
                spring = spring * (limit / elastic)
            tangential = -min(size, limit) / speed * slip if speed > 0.0 else 0.0 * slip
        elif size > limit:
            tangential = trial * (limit / size)
            if advance and k > 0.0:
                spring = -(tangential + damping * slip) / k
        else:
            tangential = trial
        return normal_force * away + tangential, spring


class Frame:
    """Bodies at one moment, ordered by id. `chains[k]`: number of spheres, 0 for a smooth body."""

    def __init__(self, ids, types, mass, moments, axes, x, v, omega, quaternion, chains):
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
    """A wall: `normal` points from the bodies into it; `place(time)` a point, `velocity` of its surface."""

    def __init__(self, normal, place, velocity=(0.0, 0.0, 0.0), type=0):
        self.normal, self.place, self.velocity = np.array(normal, float), place, np.array(velocity, float)
        self.type = type


class BruteForce:
    """Keeps the friction springs from step to step; nothing else."""

    def __init__(self, law, periods, walls=(), average=False):
        self.law, self.walls, self.average = law, walls, average
        self.periods = np.array(periods, float)  # infinite: not periodic
        self.springs = {}
        self.chains = {}

    def spheres(self, frame, k):
        key = (frame.axes[k][0], frame.axes[k][1], frame.chains[k])
        if key not in self.chains:
            self.chains[key] = sphere_chain(*key)
        x, r = self.chains[key]
        return np.outer(x, frame.turn[k][:, 0]), r

    def near_pairs(self, frame):
        """(i, j, image, way): all pairs and all images whose bounding spheres overlap; a body and its own image
        once."""
        reach = frame.axes.max(1) * 1.001
        finite = np.isfinite(self.periods)
        length = np.where(finite, self.periods, 0.0)
        i, j = np.triu_indices(len(frame.ids))
        base = frame.x[j] - frame.x[i]
        nearest = np.where(finite, -np.round(base / np.where(finite, self.periods, 1.0)), 0.0)
        around = np.array(list(itertools.product(*[range(-2, 3) if f else (0,) for f in finite])))
        image = (nearest[:, None, :] + around[None, :, :]).astype(int)
        way = base[:, None, :] + image * length
        near = (way ** 2).sum(2) < (reach[i] + reach[j])[:, None] ** 2
        return [(i[p], j[p], tuple(image[p, m]), way[p, m]) for p, m in np.argwhere(near)
                if i[p] != j[p] or tuple(image[p, m]) > (0, 0, 0)]

    def contacts(self, frame):
        """{(id i, id j, image, sphere, sphere): (i, j, way, overlap, normal, point, reduced radius, weight)}."""
        near, found = self.near_pairs(frame), {}
        smooth = [p for p in near if frame.chains[p[0]] == 0]
        if smooth:
            shapes = np.einsum("nij,nj,nkj->nik", frame.turn, frame.axes ** 2, frame.turn)
            i, j = np.array([p[0] for p in smooth]), np.array([p[1] for p in smooth])
            overlap, normal, point, _, _, radius = smooth_contacts(shapes[i], shapes[j],
                                                                   np.array([p[3] for p in smooth]))
            for k in np.flatnonzero(overlap > 0.0):
                a, b, image, way = smooth[k]
                found[frame.ids[a], frame.ids[b], image, -1, -1] = (
                    a, b, way, overlap[k], normal[k], point[k], radius[k], 1.0)
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
                    a, b, way, h, n, c[p] + (r[p] - 0.5 * h) * n, r[p] * s[q] / (r[p] + s[q]), weight)
        return found

    def wall_contacts(self, frame, time):
        """{(id, number of the wall, sphere): (k, wall, overlap, point, radius, weight)}."""
        found = {}
        for number, wall in enumerate(self.walls):
            n, place = wall.normal, np.array(wall.place(time))
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
        springs, rows = {}, {}
        for key, (i, j, way, h, n, point, radius, weight) in self.contacts(frame).items():
            at_j = point - way
            relative = v[i] + np.cross(omega[i], point) - v[j] - np.cross(omega[j], at_j)
            mass = frame.mass[i] * frame.mass[j] / (frame.mass[i] + frame.mass[j])
            f, springs[key] = self.law.force((frame.types[i], frame.types[j]), mass, (h, n, radius), relative,
                                             self.springs.get(key, np.zeros(3)), advance)
            f = weight * f
            force[i] += f
            force[j] -= f
            torque[i] += np.cross(point, f)
            torque[j] -= np.cross(at_j, f)
            virial += np.outer(-way, f)
            rows[key] = (h, n, frame.x[i] + point, f)
        for key, (k, wall, h, point, radius, weight) in self.wall_contacts(frame, time).items():
            relative = v[k] + np.cross(omega[k], point) - (wall.velocity if wall_moves else 0.0)
            f, springs[key] = self.law.force((frame.types[k], wall.type), frame.mass[k], (h, wall.normal, radius),
                                             relative, self.springs.get(key, np.zeros(3)), advance)
            force[k] += weight * f
            torque[k] += np.cross(point, weight * f)
        if advance:
            self.springs = springs
        return force, torque, rows, virial


#: Of dumps that replay() reads, with all digits.
REPLAYED = ("id type mass xu yu zu vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez "
            "fx fy fz tqx tqy tqz").split()


def replay(brute, frames, time_step, spheres=0):
    """Forces (N, 3), torques and contact list of each frame (F, N, columns of REPLAYED) of a run that was dumped every step,
    by brute force, from the positions of the dump. `spheres`: of each body; 0: smooth."""
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
        force, torque, rows, _ = brute.step(frame, 0.0, v, omega, advance=k > 0)
        yield force, torque, rows
        before = frame, values[:, 19:22], values[:, 22:25]
