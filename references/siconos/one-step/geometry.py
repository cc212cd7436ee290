"""Bodies, walls, and their contact points by brute force, for make.py."""

import math

ALERT = 0.02  # largest gap of a point, for a mean diameter of 1
UNIT_COLUMNS = ["inverse_mass_x", "inverse_mass_y", "inverse_moment", "vx", "vy", "omega", "fx", "fy", "torque"]
POINT_COLUMNS = ["first", "second", "normal", "first_n", "first_t", "second_n", "second_t", "gap"]
IMPOSED = (0.0, 0.0, 0.0)


class Body:
    """A disc (0 sides) or a regular polygon of density one, whose first vertex is at its angle."""

    def __init__(self, sides, radius, x, y, angle, unit):
        self.sides, self.radius, self.unit = sides, radius, unit
        self.x, self.y, self.angle = x, y, angle

    def vertices(self):
        step = 2 * math.pi / self.sides
        angles = [self.angle + step * k for k in range(self.sides)]
        return [(self.radius * math.cos(a), self.radius * math.sin(a)) for a in angles]

    def inverse_mass(self):
        """For both directions and the rotation."""
        square = self.radius * self.radius
        if self.sides == 0:
            mass, moment = math.pi * square, square / 2
        else:
            turn = 2 * math.pi / self.sides
            mass = self.sides / 2 * square * math.sin(turn)
            moment = square * (2 + math.cos(turn)) / 6
        return 1 / mass, 1 / mass, 1 / (mass * moment)


class Scene:
    """Units with velocities and loads, bodies, and walls (normal, distance from the origin along it, unit)."""

    def __init__(self, friction=0.4, time_step=0.01, restitution=(0.0, 0.0), period=None):
        self.friction, self.time_step, self.restitution, self.period = friction, time_step, restitution, period
        self.masses, self.velocities, self.loads = [], [], []
        self.bodies, self.walls = [], []

    def unit(self, mass=IMPOSED, velocity=(0.0, 0.0, 0.0), load=(0.0, 0.0, 0.0)):
        self.masses.append(tuple(mass))
        self.velocities.append(list(velocity))
        self.loads.append(list(load))
        return len(self.masses) - 1

    def free(self, sides, radius, x, y, angle=0.0, velocity=(0.0, 0.0, 0.0), gravity=(0.0, 0.0)):
        body = Body(sides, radius, x, y, angle, None)
        mass = body.inverse_mass()
        body.unit = self.unit(mass, velocity, (gravity[0] / mass[0], gravity[1] / mass[0], 0.0))
        self.bodies.append(body)
        return body.unit

    def wall(self, angle, distance, unit):
        self.walls.append((angle, distance, unit))

    def shift(self, dx):
        return dx - self.period * round(dx / self.period) if self.period else dx

    def can_touch(self, one, other):
        return one != other and (self.masses[one] != IMPOSED or self.masses[other] != IMPOSED)

    def pairs(self, margin):
        bodies = self.bodies
        for j, b in enumerate(bodies):
            for i, a in enumerate(bodies[:j]):
                reach, dy = a.radius + b.radius + margin, b.y - a.y
                if -reach < dy < reach and self.can_touch(a.unit, b.unit):
                    if math.hypot(self.shift(b.x - a.x), dy) < reach:
                        yield i, j

    def points(self, pairs=None, allowed=ALERT):
        """Rows of the table of points, and a name for each of them."""
        rows, names = [], []
        corners = [body.vertices() if body.sides else None for body in self.bodies]
        for i, j in pairs if pairs is not None else self.pairs(allowed):
            a, b = self.bodies[i], self.bodies[j]
            d = (self.shift(b.x - a.x), b.y - a.y)
            found = between(a, b, corners[i], corners[j], d, allowed)
            rows += [[a.unit, b.unit, *point] for point in found]
            names += [(i, j, n) for n in range(len(found))]
        for w, (angle, distance, unit) in enumerate(self.walls):
            for j, body in enumerate(self.bodies):
                if self.can_touch(unit, body.unit):
                    found = at_wall(body, corners[j], angle, distance, allowed)
                    rows += [[unit, body.unit, *point] for point in found]
                    names += [(-1 - w, j, n) for n in range(len(found))]
        return rows, names

    def problem(self, rows):
        return {
            "friction": self.friction,
            "normal_restitution": self.restitution[0],
            "tangential_restitution": self.restitution[1],
            "time_step": self.time_step,
            "units": {
                "columns": UNIT_COLUMNS,
                "rows": [[*m, *v, *f] for m, v, f in zip(self.masses, self.velocities, self.loads)],
            },
            "points": {"columns": POINT_COLUMNS, "rows": rows},
        }


def between(a, b, mine, others, d, allowed):
    """Points of two bodies of the same kind at the displacement d: direction of the normal, arms, gap."""
    if a.sides == 0:
        gap = math.hypot(*d) - a.radius - b.radius
        if gap > allowed:
            return []
        return [[math.atan2(d[1], d[0]), a.radius + gap / 2, 0.0, -b.radius - gap / 2, 0.0, gap]]
    one = widest(mine, others, d, allowed)
    if one[0] > allowed:
        return []
    other = widest(others, mine, (-d[0], -d[1]), allowed)
    if other[0] > allowed:
        return []
    if one[0] >= other[0] - 1e-6:
        return clipped(mine, others, d, one[1], allowed)
    turned = clipped(others, mine, (-d[0], -d[1]), other[1], allowed)
    return [[turn(angle), -bn, -bt, -an, -at, gap] for angle, an, at, bn, bt, gap in turned]


def turn(angle):
    return angle - math.pi if angle > 0 else angle + math.pi


def side(corners, k):
    """Corner, direction along and outward normal of a side."""
    (px, py), (qx, qy) = corners[k], corners[(k + 1) % len(corners)]
    length = math.hypot(qx - px, qy - py)
    tx, ty = (qx - px) / length, (qy - py) / length
    return px, py, length, tx, ty, ty, -tx


def widest(mine, others, d, allowed):
    """The largest separation over the sides of one polygon, and the side."""
    best = (-math.inf, 0)
    for k in range(len(mine)):
        px, py, _, _, _, nx, ny = side(mine, k)
        offset = nx * (d[0] - px) + ny * (d[1] - py)
        separation = min(nx * x + ny * y for x, y in others) + offset
        best = max(best, (separation, k))
        if separation > allowed:
            break
    return best


def clipped(mine, others, d, k, allowed):
    """The ends of the opposite side within the lateral extent of side k, moved onto a common line."""
    px, py, length, tx, ty, nx, ny = side(mine, k)
    facing = min(range(len(others)), key=lambda j: nx * side(others, j)[5] + ny * side(others, j)[6])
    ends = []
    for x, y in (others[facing], others[(facing + 1) % len(others)]):
        rx, ry = x + d[0] - px, y + d[1] - py
        ends.append((rx * tx + ry * ty, rx * nx + ry * ny))
    (s, g), (s2, g2) = ends
    kept = []
    for place, gap in ends:
        held = min(max(place, 0.0), length)
        if held != place and not min(s, s2) <= held <= max(s, s2):
            continue
        if held != place:
            gap = g + (g2 - g) * (held - s) / (s2 - s)
        if gap <= allowed:
            kept.append((gap, held))
    if len(kept) == 2 and abs(kept[0][1] - kept[1][1]) < 1e-4:
        kept = [min(kept)]
    if not kept:
        return []
    line = sum(gap for gap, _ in kept) / (2 * len(kept))
    # The tangent is the normal turned by +90 degrees, which is the direction along the side.
    depth, along = nx * px + ny * py + line, tx * px + ty * py
    across, beside = nx * d[0] + ny * d[1], tx * d[0] + ty * d[1]
    angle = math.atan2(ny, nx)
    return [
        [angle, depth, along + place, depth - across, along + place - beside, gap] for gap, place in kept
    ]


def at_wall(body, corners, angle, distance, allowed):
    """Points of a body at a wall, which has no arms because it does not turn."""
    nx, ny = math.cos(angle), math.sin(angle)
    height = nx * body.x + ny * body.y - distance
    if body.sides == 0:
        gap = height - body.radius
        return [[angle, 0.0, 0.0, -body.radius - gap / 2, 0.0, gap]] if gap <= allowed else []
    kept = []
    for x, y in corners:
        gap = height + nx * x + ny * y
        if gap <= allowed:
            kept.append((gap, nx * y - ny * x))
    line = sum(gap for gap, _ in kept) / (2 * len(kept)) if kept else 0.0
    return [[angle, 0.0, 0.0, line - height, place, gap] for gap, place in kept]
