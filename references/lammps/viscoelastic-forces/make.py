"""Random contacts, far apart from each other; writes particles/1.csv."""

import math
import pathlib
import random

random.seed(1)
folder = pathlib.Path(__file__).parent / "particles"
folder.mkdir(exist_ok=True)
with (folder / "1.csv").open("w") as out:
    print("x,y,vx,vy,angular_velocity,radius,density,role", file=out)
    for n in range(48):
        radii = (1e-3, 1e-3)
        distance = sum(radii) - min(radii) * 10 ** random.uniform(-2.0, -0.5)
        angle = random.uniform(0.0, 2 * math.pi)
        x, y = 0.02 * (n % 8 - 3.5), 0.02 * (n // 8 - 2.5)
        places = [(x, y), (x + distance * math.cos(angle), y + distance * math.sin(angle))]
        for (x, y), radius in zip(places, radii):
            velocity = [random.uniform(-2.0, 2.0) for _ in range(2)]
            spin = random.uniform(-2000.0, 2000.0)
            print(*map(repr, (x, y, *velocity, spin, radius, 2700.0)), "free", sep=",", file=out)
