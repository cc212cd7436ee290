"""Solve a step of rigid bodies with frictional contacts by Siconos: python3 run.py problem=NAME

Reads NAME.json and writes found.json: velocities of the units, impulses of the points, and how far the solutions from
several starts and orders of the points are from the laws and from each other. The library is used through its C
interface, so that neither headers nor a compiler nor other packages are needed.

A problem has units (what moves as one) and points. With u = H v the relative velocities of the points, the impulses
P satisfy the laws of Signorini and Coulomb with w = W P + q, W = H M^-1 H^T, where q has the velocities without
contact impulses, the restitution e u- and the permitted approach g/dt.
"""

import ctypes
import json
import math
import pathlib
import random
import sys
import tempfile

NSGS, LEMKE = 400, 404
MAX_ITERATIONS, TOLERANCE = 0, 0
ITERATIONS_DONE = 1

# Larger problems are solved in two orders only, which does not show which impulses are unique.
LARGEST_FOR_MANY_STARTS = 200

MOST_ITERATIONS = 50_000

# Impulses that differ by less than this part of the largest one are the same.
UNIQUE = 1e-8

# Residual, in units of the scale, of a solution of Lemke's method that sweeps can improve. The method pivots in a dense
# matrix of three rows per point, half a minute for 700 points, and may end without a solution.
GOOD_START = 1e-4


class Options(ctypes.Structure):
    """The beginning of the structure SolverOptions of Siconos 4.4."""

    _fields_ = [
        ("solver", ctypes.c_int),
        ("is_set", ctypes.c_bool),
        ("integers", ctypes.c_int),
        ("iparam", ctypes.POINTER(ctypes.c_int)),
        ("doubles", ctypes.c_int),
        ("dparam", ctypes.POINTER(ctypes.c_double)),
    ]


def library():
    siconos = ctypes.CDLL("libsiconos_numerics.so.7")
    siconos.solver_options_create.restype = ctypes.POINTER(Options)
    siconos.frictionContact_new_from_filename.restype = ctypes.c_void_p
    siconos.frictionContactProblem_free.argtypes = [ctypes.c_void_p]
    vector = ctypes.POINTER(ctypes.c_double)
    siconos.fc2d_driver.argtypes = [ctypes.c_void_p, vector, vector, ctypes.POINTER(Options)]
    siconos.solver_options_delete.argtypes = [ctypes.POINTER(Options)]
    return siconos


class Problem:
    """Rows of H, the operator W by blocks, and q."""

    def __init__(self, data):
        self.units = [dict(zip(data["units"]["columns"], row)) for row in data["units"]["rows"]]
        self.points = [dict(zip(data["points"]["columns"], row)) for row in data["points"]["rows"]]
        self.friction, self.time_step = data["friction"], data["time_step"]
        self.restitution = data["normal_restitution"], data["tangential_restitution"]
        self.masses = [(u["inverse_mass_x"], u["inverse_mass_y"], u["inverse_moment"]) for u in self.units]
        self.before = [(u["vx"], u["vy"], u["omega"]) for u in self.units]
        self.free = [
            tuple(v + data["time_step"] * w * f for v, w, f in zip(before, mass, (u["fx"], u["fy"], u["torque"])))
            for u, before, mass in zip(self.units, self.before, self.masses)
        ]
        self.rows = [rows_of(point) for point in self.points]
        self.assemble()

    def assemble(self):
        """Blocks of W in row-major order, and q."""
        points_of = {}
        for k, point in enumerate(self.points):
            for side in ("first", "second"):
                points_of.setdefault(point[side], []).append(k)
        self.blocks, self.q = [], []
        for k, point in enumerate(self.points):
            mine = {}
            for unit in (point["first"], point["second"]):
                for other in points_of[unit]:
                    block = mine.setdefault(other, [[0.0, 0.0], [0.0, 0.0]])
                    for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
                        pairs = zip(self.rows[k][i][unit], self.masses[unit], self.rows[other][j][unit])
                        block[i][j] += sum(a * w * b for a, w, b in pairs)
            self.blocks.append(mine)
            self.q.append(self.constant(k))

    def constant(self, k):
        """The velocities to which the laws of a point apply, without contact impulses."""
        gap = self.points[k]["gap"]
        u = self.relative(k, self.free)
        if gap <= 0:
            u = [now + e * old for now, e, old in zip(u, self.restitution, self.relative(k, self.before))]
        return [u[0] + max(gap, 0.0) / self.time_step, u[1]]

    def relative(self, k, velocities):
        return [
            sum(a * v for unit, row in part.items() for a, v in zip(row, velocities[unit]))
            for part in self.rows[k]
        ]

    def velocities(self, impulses):
        """Velocities of all units after the step."""
        found = [list(v) for v in self.free]
        for k, impulse in enumerate(impulses):
            for part, p in zip(self.rows[k], impulse):
                for unit, row in part.items():
                    for c in range(3):
                        found[unit][c] += self.masses[unit][c] * row[c] * p
        return found

    def residual(self, impulses):
        """The largest residual of the laws in m/s (natural map), from the velocities of the units."""
        after, worst = self.velocities(impulses), 0.0
        for k, (n, t) in enumerate(impulses):
            u, w = self.relative(k, after), self.blocks[k][k]
            shift = [q - free for q, free in zip(self.q[k], self.relative(k, self.free))]
            rate, limit = max(w[0][0], w[1][1]), self.friction * max(n, 0.0)
            normal = n - max(n - (u[0] + shift[0]) / rate, 0.0)
            tangential = t - min(max(t - (u[1] + shift[1]) / rate, -limit), limit)
            worst = max(worst, rate * abs(normal), rate * abs(tangential))
        return worst

    def scale(self):
        """The largest of the velocities to which the laws apply, without contact impulses."""
        return max(abs(x) for q in self.q for x in q)


def rows_of(point):
    """Normal and tangential row of H: coefficients of the velocities (x, y, rotation) of both units."""
    nx, ny = math.cos(point["normal"]), math.sin(point["normal"])
    normal, tangent = {}, {}
    for sign, side in ((-1.0, "first"), (1.0, "second")):
        arm_n, arm_t = point[f"{side}_n"], point[f"{side}_t"]
        normal[point[side]] = (sign * nx, sign * ny, -sign * arm_t)
        tangent[point[side]] = (-sign * ny, sign * nx, sign * arm_n)
    return normal, tangent


def text_for_siconos(problem, order):
    """The problem in the format that Siconos reads, with its points in the given order."""
    count, place = len(order), {k: n for n, k in enumerate(order)}
    sizes = " ".join(str(2 * (n + 1)) for n in range(count))
    starts, columns, values = [0], [], []
    for k in order:
        row = sorted((place[other], block) for other, block in problem.blocks[k].items())
        columns += [str(other) for other, _ in row]
        # Each block has its number in front, and is column-major.
        values += [
            " ".join([str(len(values) + n), *(repr(block[i][j]) for j in (0, 1) for i in (0, 1))])
            for n, (_, block) in enumerate(row)
        ]
        starts.append(len(columns))
    head = ["2", str(count), "1", f"{2 * count} {2 * count}", str(len(columns)), f"{count} {count}", sizes, sizes]
    index = [f"{count + 1} {len(columns)}", " ".join(map(str, starts)), " ".join(columns)]
    q = " ".join(repr(x) for k in order for x in problem.q[k])
    return "\n".join([*head, *index, *values, q, " ".join([repr(problem.friction)] * count)]) + "\n"


class Solver:
    """The solvers of Siconos for one order of the points."""

    def __init__(self, siconos, problem, order):
        self.siconos, self.order = siconos, order
        with tempfile.NamedTemporaryFile("w", suffix=".dat") as file:
            file.write(text_for_siconos(problem, order))
            file.flush()
            self.handle = siconos.frictionContact_new_from_filename(file.name.encode())
        if not self.handle:
            sys.exit("Siconos could not read the problem")

    def solve(self, method, start, tolerance, iterations):
        """Impulses in the order of the problem, and the number of iterations."""
        size = 2 * len(self.order)
        impulses, velocities = (ctypes.c_double * size)(), (ctypes.c_double * size)()
        for n, k in enumerate(self.order):
            impulses[2 * n], impulses[2 * n + 1] = start[k]
        options = self.siconos.solver_options_create(method)
        options.contents.iparam[MAX_ITERATIONS] = iterations
        options.contents.dparam[TOLERANCE] = tolerance
        self.siconos.fc2d_driver(self.handle, impulses, velocities, options)
        done = options.contents.iparam[ITERATIONS_DONE]
        self.siconos.solver_options_delete(options)
        found = [None] * len(self.order)
        for n, k in enumerate(self.order):
            found[k] = (impulses[2 * n], impulses[2 * n + 1])
        return found, done

    def free(self):
        self.siconos.frictionContactProblem_free(self.handle)


def attempts(problem):
    """Methods with orders of the points and starts; a start is a function of the first solution."""
    count = len(problem.points)
    forward = list(range(count))
    shuffled = random.Random(1).sample(forward, count)
    draw = random.Random(2)

    def zero(_):
        return [(0.0, 0.0)] * count

    def scattered(times):
        """Impulses at random, some times as large as those of the first solution."""

        def start(first):
            largest = times * max(n for n, _ in first)
            normal = [largest * draw.random() for _ in range(count)]
            return [(n, problem.friction * n * draw.uniform(-1, 1)) for n in normal]

        return start

    if count <= LARGEST_FOR_MANY_STARTS:
        yield "NSGS", "forward", "zero", NSGS, forward, zero
        yield "NSGS", "backward", "zero", NSGS, forward[::-1], zero
        yield "NSGS", "shuffled", "zero", NSGS, shuffled, zero
        for times in (0.3, 1.0, 3.0, 10.0):
            yield "NSGS", "shuffled", f"random, {times}", NSGS, shuffled, scattered(times)
    yield "Lemke, then NSGS", "forward", "zero", LEMKE, forward, zero
    yield "Lemke, then NSGS", "shuffled", "zero", LEMKE, shuffled, zero


def distance(left, right):
    return max(abs(a - b) for one, other in zip(left, right) for a, b in zip(one, other))


def solve(data):
    """The solution of the first attempt, and what the others say about it."""
    problem, siconos = Problem(data), library()
    scale, found, told = problem.scale(), [], []
    for method, order_name, start_name, number, order, start in attempts(problem):
        solver = Solver(siconos, problem, order)
        impulses, iterations = solver.solve(number, start(found[0] if found else None), 1e-15, MOST_ITERATIONS)
        if number == LEMKE and problem.residual(impulses) < GOOD_START * scale:
            impulses, sweeps = solver.solve(NSGS, impulses, 1e-15, MOST_ITERATIONS)
            iterations += sweeps
        elif number == LEMKE:
            impulses = None
        solver.free()
        if impulses is None:
            continue
        residual = problem.residual(impulses) / scale
        found.append(impulses)
        told.append([method, order_name, start_name, iterations, residual])
    best = min(range(len(found)), key=lambda k: told[k][4])
    return problem, found, best, told


def report(problem, found, best, told):
    scale = problem.scale()
    chosen = [[rounded(x) for x in impulse] for impulse in found[best]]
    velocities = problem.velocities(chosen)
    for row, impulses in zip(told, found):
        row.append(distance(problem.velocities(impulses), velocities) / scale)
    largest = max(abs(x) for impulse in chosen for x in impulse) or 1.0
    is_asked = len(chosen) <= LARGEST_FOR_MANY_STARTS
    spread = [max(distance([mine], [other[k]]) for other in found) for k, mine in enumerate(chosen)]
    return {
        "scale": scale,
        "residual": problem.residual(chosen) / scale,
        "solves": {
            "columns": ["method", "order", "start", "iterations", "residual", "velocity_difference"],
            "rows": [[float(f"{x:.2e}") if isinstance(x, float) else x for x in row] for row in told],
        },
        "velocities": {"columns": ["vx", "vy", "omega"], "rows": [list(map(rounded, v)) for v in velocities]},
        "impulses": {
            "columns": ["normal", "tangential", "unique"],
            "rows": [[*p, int(is_asked and s <= UNIQUE * largest)] for p, s in zip(chosen, spread)],
        },
    }


def rounded(x):
    return float(f"{x:.15g}")


def main():
    given = dict(word.split("=") for word in sys.argv[1:])
    data = json.loads(pathlib.Path(f"{given['problem']}.json").read_text())
    pathlib.Path("found.json").write_text(json.dumps(report(*solve(data))))


if __name__ == "__main__":
    main()
