"""A hexagonal block of equal discs, bonded but for one bond in twelve; writes particles/SEED.csv and bonds/SEED.csv."""

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
    rise = 0.002 * math.sqrt(0.75)
    places = [(0.002 * (n % 10) + 0.001 * (n // 10 % 2), rise * (n // 10)) for n in range(120)]
    rows = []
    for n, (x, y) in enumerate(places):
        if n < 10:
            rows.append((x, y, 0.0, 0.0, 1e-3, 2700.0, "fixed"))
        elif n < 110:
            rows.append((x, y, 0.0, 0.1 * (n // 10) / 11, 1e-3, 2700.0, "free"))
        else:
            rows.append((x, y, 0.0, 0.1, 1e-3, 2.7e12, "free"))
    write(seed, rows)
    (HERE / "bonds").mkdir(exist_ok=True)
    with (HERE / "bonds" / f"{seed}.csv").open("w") as out:
        print("i,j,strength_factor", file=out)
        for j, there in enumerate(places):
            for i, here in enumerate(places[:j]):
                is_wall = j < 10 or i >= 110
                if math.dist(here, there) < 0.0021 and not is_wall and random.random() > 1 / 12:
                    print(i, j, random.choice((0.9, 0.95, 1.0, 1.05, 1.1)), sep=",", file=out)
