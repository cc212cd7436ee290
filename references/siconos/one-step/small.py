"""Small problems from their geometry, for make.py."""

import math
import random

from geometry import Scene, widest

UP, DOWN, LEFT = math.pi / 2, -math.pi / 2, math.pi
SQUARE = 1 / math.sqrt(2), math.pi / 4

# Bodies that touch overlap by this length, so that rounding does not decide about contacts.
OVERLAP = 1e-6


def column_of_squares():
    """Eight squares on a floor, the fourth pushed sideways."""
    scene = Scene()
    scene.wall(UP, 0.0, scene.unit())
    radius, angle = SQUARE
    for n in range(8):
        scene.free(4, radius, 0.01 * (n % 3), (0.5 + n) * (1 - OVERLAP), angle, gravity=(0.0, -1.0))
    scene.loads[4][0] = 1.5
    return scene


def pile_of_discs():
    """A pyramid of discs on a floor, hit from above."""
    scene = Scene(friction=0.1)
    scene.wall(UP, 0.0, scene.unit())
    pitch = 1 - OVERLAP
    for row in range(8):
        for n in range(8 - row):
            place = (n + row / 2) * pitch, (0.5 + row * math.sqrt(0.75)) * pitch
            scene.free(0, 0.5, *place, gravity=(0.0, -1.0))
    scene.velocities[-1] = [0.0, -0.1, 0.0]
    return scene


def pile_of_hexagons():
    """Hexagons that lie on each other with their sides, on a floor that is slippery."""
    scene = Scene(friction=0.1)
    scene.wall(UP, 0.0, scene.unit())
    radius, pitch = 1 / math.sqrt(3), 1 - OVERLAP
    for row in range(5):
        for n in range(7 - row):
            place = (n + row / 2) * pitch, (1 + 1.5 * row) * radius * pitch
            scene.free(6, radius, *place, UP, gravity=(0.0, -1.0))
    return scene


def wall_of_bricks():
    """Squares in rows that are shifted by half a side and do not touch their neighbours, on a slope."""
    scene = Scene(friction=0.3)
    scene.wall(UP, 0.0, scene.unit())
    radius, angle = SQUARE
    slope = 0.4
    for row in range(4):
        for n in range(4):
            place = 1.05 * (n + 0.5 * (row % 2)), (0.5 + row) * (1 - OVERLAP)
            scene.free(4, radius, *place, angle, gravity=(math.sin(slope), -math.cos(slope)))
    return scene


def pentagons_under_a_lid():
    """A row of pentagons between a floor and a loaded lid that moves sideways: one of its directions is imposed."""
    scene = Scene()
    scene.wall(UP, 0.0, scene.unit())
    lid = scene.unit((0.0, 0.5, 0.0), (0.4, 0.0, 0.0), (0.0, -5.0, 0.0))
    height = 0.5 * (1 + math.cos(math.pi / 5))
    scene.wall(DOWN, -height * (1 - OVERLAP), lid)
    for n in range(9):
        angle = UP if n % 2 == 0 else DOWN
        y = 0.5 * math.cos(math.pi / 5) if n % 2 == 0 else 0.5
        scene.free(5, 0.5, 0.75 * n, y * (1 - OVERLAP), angle, (0.0, 0.0, 0.1 * (n % 4)))
    return scene


def pushed_discs():
    """Discs of many sizes on a floor, pushed by a side wall that is driven, below a lid that carries a load."""
    scene = Scene(friction=0.2)
    fixed = scene.unit()
    side = scene.unit(velocity=(-0.2, 0.0, 0.0))
    draw = random.Random(5)
    radii = [[0.4 + 0.2 * draw.random() for _ in range(6)] for _ in range(6)]
    y = 0.0
    for row in radii:
        x = 0.0
        for radius in row:
            scene.free(0, radius, x + radius, y + 0.5 + 0.3 * (0.5 - radius), gravity=(0.0, -0.2))
            x += 2 * radius - 1e-3
        y += 0.85
    scene.wall(UP, 0.0, fixed)
    scene.wall(LEFT, -max(b.x + b.radius for b in scene.bodies), side)
    lid = scene.unit((0.0, 0.1, 0.0), load=(0.0, -3.0, 0.0))
    scene.wall(DOWN, -max(b.y + b.radius for b in scene.bodies), lid)
    return scene


def heap(sides, count, seed, gap, **scene):
    """Bodies that come towards the middle from random directions until they nearly touch, with random velocities."""
    scene = Scene(**scene)
    draw = random.Random(seed)
    for _ in range(count):
        way, angle, radius = draw.uniform(-math.pi, math.pi), draw.uniform(0, math.pi), draw.uniform(0.4, 0.7)
        velocity = [round(draw.uniform(-1, 1), 3) for _ in range(3)]
        scene.free(sides, radius, 0.0, 0.0, angle, velocity)
        body, others = scene.bodies[-1], scene.bodies[:-1]
        target, inside, outside = draw.uniform(*gap), 0.0, 20.0
        for _ in range(60 if others else 0):
            middle = (inside + outside) / 2
            body.x, body.y = middle * math.cos(way), middle * math.sin(way)
            if min(separation(body, other) for other in others) > target:
                outside = middle
            else:
                inside = middle
    return scene


def separation(a, b):
    d = (b.x - a.x, b.y - a.y)
    if a.sides == 0:
        return math.hypot(*d) - a.radius - b.radius
    mine, others = a.vertices(), b.vertices()
    back = (-d[0], -d[1])
    return max(widest(mine, others, d, math.inf)[0], widest(others, mine, back, math.inf)[0])


SMALL = {
    "column-of-squares": column_of_squares,
    "pile-of-discs": pile_of_discs,
    "pile-of-hexagons": pile_of_hexagons,
    "wall-of-bricks": wall_of_bricks,
    "pentagons-under-a-lid": pentagons_under_a_lid,
    "pushed-discs": pushed_discs,
    "rebounding-discs": lambda: heap(0, 50, 1, (-0.002, -0.001), restitution=(0.6, 0.3)),
    "rebounding-triangles": lambda: heap(3, 40, 2, (-0.002, -0.001), restitution=(0.5, 0.0), friction=0.6),
    "triangles-with-gaps": lambda: heap(3, 60, 3, (-0.002, 0.015)),
    "hexagons-without-friction": lambda: heap(6, 50, 4, (-0.002, 0.015), friction=0.0),
}
