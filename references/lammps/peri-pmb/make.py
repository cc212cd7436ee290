"""A plate of 20 x 8 nodes that vibrates or tears; writes particles/RUN.csv.

Numbers of nodes of a row, not places, enter velocities and volumes, so that they need few digits:
u and v run from -1 to 1 along the length and across. Noise leaves no two bonds alike, so that no tie decides which of
them breaks.
"""

import pathlib
import random

HERE = pathlib.Path(__file__).parent
COLUMNS, ROWS = 20, 8
SPACING = 1 / 16
DENSITY = 1200.0


def vibration(u, v):
    """Stretching along the length, bending of third order, and shear."""
    return 30 * u + 8 * v, 25 * (u**3 - 0.6 * u) - 10 * v


def tear(u, v):
    """The halves part, faster on one side."""
    return (18 + 6 * v) * (1 if u > 0.1 * v else -1), 0.0


def write(name, velocity, spread):
    """A run whose volumes differ from those of cells by up to the spread, relative."""
    random.seed(name)
    (HERE / "particles").mkdir(exist_ok=True)
    with (HERE / "particles" / f"{name}.csv").open("w") as out:
        print("x,y,vx,vy,volume,density", file=out)
        for n in range(COLUMNS * ROWS):
            column, row = n % COLUMNS, n // COLUMNS
            place = (2 * column / (COLUMNS - 1) - 1, 2 * row / (ROWS - 1) - 1)
            vx, vy = (round(part + random.uniform(-0.5, 0.5), 4) for part in velocity(*place))
            volume = SPACING**2 * round(1 + spread * random.uniform(-1, 1), 3)
            numbers = (column * SPACING, row * SPACING, vx, vy, volume, DENSITY)
            print(*map(repr, numbers), sep=",", file=out)


write("vibration", vibration, 0.3)
write("tear", tear, 0.0)
write("tear-unequal", tear, 0.3)
