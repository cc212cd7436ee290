"""A dense jittered lattice of discs of many sizes between two rows; writes particles/SEED.csv."""

import math
import pathlib
import random

HERE = pathlib.Path(__file__).parent
SEEDS = range(1, 48 + 1)


def write(seed, rows):
    """Rows of x, y, vx, vy, radius, density and role."""
    (HERE / "particles").mkdir(exist_ok=True)
    with (HERE / "particles" / f"{seed}.csv").open("w") as out:
        print("x,y,vx,vy,angular_velocity,radius,density,role", file=out)
        for x, y, vx, vy, radius, density, role in rows:
            numbers = (round(x, 9), round(y, 9), round(vx, 6), round(vy, 6), 0.0, round(radius, 9))
            print(*map(repr, numbers), repr(density), role, sep=",", file=out)



for seed in SEEDS:
    random.seed(seed)
    rows = [(0.001 + 0.002 * n, 0.0, 0.0, 0.0, 1e-3, 2700.0, "fixed") for n in range(10)]
    rise = 0.002 * math.sqrt(0.75)
    radii = [random.uniform(0.8e-3, 1.2e-3) for _ in range(100)]
    size = math.sqrt(100 * 1.0e-6 / sum(radius * radius for radius in radii))
    for n, radius in enumerate(radii):
        x = 0.002 * (n % 10) + 0.001 * (n // 10 % 2) + random.uniform(-1e-4, 1e-4)
        y = rise * (1 + n // 10) + random.uniform(-1e-4, 1e-4)
        velocity = (2 * y / rise / 11, 0.0)
        rows.append((x % 0.02, y, *velocity, size * radius, 2700.0, "free"))
    rows += [(0.001 + 0.002 * n, 11 * rise, 2.0, 0.0, 1e-3, 2.7e12, "free") for n in range(10)]
    write(seed, rows)
