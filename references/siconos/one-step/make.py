"""Write the problems: python3 make.py [NAME ...]

Small ones are built from their geometry. Snapshots of sheared packings start from packings of `lmgc90/shear`; smaller
cells are cut from them, and their grains, also polygons inscribed in the discs, compacted. Siconos then solves step after
step, and the problem of the last step is written.
"""

import csv
import json
import math
import pathlib
import sys

import run
from geometry import Body, Scene
from small import DOWN, SMALL, UP

HERE = pathlib.Path(__file__).resolve().parent
SHEAR = HERE.parent.parent / "lmgc90" / "shear"

# Width of the sheared cells, and inertial number, both with mean diameter, density and normal stress one.
WIDTH, INERTIA = 20.0, 1e-3
STRAIN_PER_STEP, STEPS = 1e-4, 300
FIXED, DRIVEN = 0, 1


def walls(scene, height, inverse_mass):
    """A fixed lower wall, and an upper one that carries the normal stress."""
    scene.unit()
    scene.unit((0.0, inverse_mass, 0.0), load=(0.0, -scene.period, 0.0))
    scene.walls = [(UP, 0.0, FIXED), (DOWN, -height, DRIVEN)]


def stored(name):
    """A packing of `lmgc90/shear`."""
    packing = json.loads((SHEAR / "result.json").read_text())["packings"][name]
    scene = Scene(time_step=STRAIN_PER_STEP / INERTIA, period=WIDTH)
    walls(scene, packing["height"], packing["inverse_wall_mass"])
    units = {"bottom": FIXED, "top": DRIVEN}
    for row in csv.DictReader((SHEAR / packing["file"]).open()):
        place = (int(row["sides"]), *(float(row[key]) for key in ("radius", "x", "y", "angle")))
        if row["role"] == "free":
            scene.free(*place)
        else:
            scene.bodies.append(Body(*place, units[row["role"]]))
    return scene


def cut(sides):
    """Grains of a quarter of the packed discs, with a smaller period and without friction, before compaction."""
    period, height = WIDTH / 2, 11.0
    scene = Scene(friction=0.0, time_step=0.2, period=period)
    walls(scene, height, 0.05)
    for n, body in enumerate(stored("discs").bodies):
        is_inside = 0 <= body.x < period and body.radius <= body.y <= height - body.radius
        is_apart = all(
            math.hypot(scene.shift(body.x - other.x), body.y - other.y) > body.radius + other.radius - 1e-3
            for other in scene.bodies
        )
        if is_inside and is_apart:
            scene.free(sides, body.radius, body.x, body.y, 2.4 * n)
    return scene


def compacted(sides):
    """Grains inscribed in packed discs, compacted without friction; those at a wall are glued to it."""
    scene = cut(sides)
    mover = Mover(scene, tolerance=1e-4)
    for _ in range(400):
        mover.step()
        scene.velocities = [[0.9 * v for v in velocity] for velocity in scene.velocities]
        scene.velocities[DRIVEN][1] = max(scene.velocities[DRIVEN][1], -0.03 / scene.time_step)
    return glued(scene)


def glued(free):
    scene = Scene(time_step=STRAIN_PER_STEP / INERTIA, period=free.period)
    height = -free.walls[1][1]
    held = {"bottom": [], "top": []}
    for body in free.bodies:
        corners = body.vertices() if body.sides else [(0.0, -body.radius), (0.0, body.radius)]
        ends = [body.y + y for _, y in corners]
        if min(ends) < 0.03:
            held["bottom"].append(body)
        elif max(ends) > height - 0.03:
            held["top"].append(body)
    walls(scene, height, 1 / sum(1 / body.inverse_mass()[0] for body in held["top"]))
    for body in free.bodies:
        for name, unit in (("bottom", FIXED), ("top", DRIVEN)):
            if body in held[name]:
                scene.bodies.append(Body(body.sides, body.radius, body.x, body.y, body.angle, unit))
                break
        else:
            scene.free(body.sides, body.radius, body.x, body.y, body.angle)
    return scene


class Mover:
    """Steps with contacts detected in the middle; the impulses of a step are the first guesses of the next one."""

    REBUILD, SKIN = 10, 0.4

    def __init__(self, scene, tolerance):
        self.scene, self.tolerance = scene, tolerance
        self.siconos, self.guesses, self.steps = run.library(), {}, 0

    def move(self, time):
        scene = self.scene
        for body in scene.bodies:
            vx, vy, omega = scene.velocities[body.unit]
            body.x, body.y, body.angle = body.x + time * vx, body.y + time * vy, body.angle + time * omega
        for n, (angle, distance, unit) in enumerate(scene.walls):
            vx, vy, _ = scene.velocities[unit]
            along = vx * math.cos(angle) + vy * math.sin(angle)
            scene.walls[n] = (angle, distance + time * along, unit)

    def step(self):
        """Take a step, and return the problem that was solved."""
        scene = self.scene
        if self.steps % self.REBUILD == 0:
            self.pairs = list(scene.pairs(self.SKIN))
        self.steps += 1
        self.move(scene.time_step / 2)
        rows, names = scene.points(self.pairs)
        data = scene.problem([rounded(row) for row in rows])
        data["units"]["rows"] = [list(row) for row in data["units"]["rows"]]
        problem = run.Problem(data)
        solver = run.Solver(self.siconos, problem, list(range(len(rows))))
        start = [self.guesses.get(name, (0.0, 0.0)) for name in names]
        impulses, _ = solver.solve(run.NSGS, start, self.tolerance, 1000)
        solver.free()
        self.guesses = dict(zip(names, impulses))
        scene.velocities = problem.velocities(impulses)
        self.move(scene.time_step / 2)
        return data


def rounded(row):
    """A point with short numbers; two points on a common line keep the same arms across it."""
    return [*row[:2], *(round(x, 9) for x in row[2:])]


def sheared(scene):
    """The problem of a step in a packing that has been sheared for a while."""
    mover = Mover(scene, tolerance=1e-5)
    for step in range(STEPS):
        height = -scene.walls[1][1]
        scene.velocities[DRIVEN][0] = INERTIA * height
        scene.velocities = [[round(v, 12) for v in velocity] for velocity in scene.velocities]
        data = mover.step()
        if step % 20 == 0:
            print(step, len(data["points"]["rows"]), height, min(row[7] for row in data["points"]["rows"]), flush=True)
    return data


def write(name, data):
    folder = HERE / "problems"
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.json").write_text(text_of(data))
    print(f"{name}: {len(data['units']['rows'])} units, {len(data['points']['rows'])} points", flush=True)


def text_of(data):
    """JSON with a row of a table a line."""
    parts = []
    for key, value in data.items():
        if isinstance(value, dict):
            rows = ",\n".join("  " + json.dumps(row) for row in value["rows"])
            value = f'{{\n  "columns": {json.dumps(value["columns"])},\n  "rows": [\n{rows}\n ]}}'
        else:
            value = json.dumps(value)
        parts.append(f' "{key}": {value}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def main():
    snapshots = {
        "sheared-discs": lambda: sheared(stored("discs")),
        "sheared-cell-of-discs": lambda: sheared(compacted(0)),
        "sheared-cell-of-hexagons": lambda: sheared(compacted(6)),
    }
    for name, make in SMALL.items():
        if len(sys.argv) == 1 or name in sys.argv:
            scene = make()
            write(name, scene.problem(scene.points()[0]))
    for name, make in snapshots.items():
        if len(sys.argv) == 1 or name in sys.argv:
            write(name, make())


if __name__ == "__main__":
    main()
