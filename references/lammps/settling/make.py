"""Discs on a jittered lattice above a floor and between two walls of fixed discs; writes particles/SEED.csv."""

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
    wall = [(0.00202 * n, 0.0) for n in range(11)]
    wall += [(x, 0.00202 * n) for n in range(1, 18) for x in (0.0, 0.0202)]
    rows = [(x, y, 0.0, 0.0, 1e-3, 2700.0, "fixed") for x, y in wall]
    radii = [random.uniform(0.7, 1.05) for _ in range(80)]
    size = 1e-3 * math.sqrt(80 * 0.875**2 / sum(radius * radius for radius in radii))
    for n, radius in enumerate(radii):
        x = 0.0021375 + 0.002275 * (n % 8) + random.uniform(-6e-5, 6e-5)
        y = 0.0022 + 0.0022 * (n // 8) + random.uniform(-4e-5, 4e-5)
        velocity = [random.uniform(-0.2, 0.2) for _ in range(2)]
        rows.append((x, y, *velocity, size * radius, 2700.0, "free"))
    write(seed, rows)
