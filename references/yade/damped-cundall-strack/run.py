"""Oblique impact of two spinning discs: spring and dashpot, and a spring up to the Coulomb limit."""

import math
import sys

from yade import *

given = dict(word.split("=") for word in sys.argv[1:])
number = lambda name: float(given[name])


def disc(position, velocity, spin, radius, fixed=False):
    """A sphere that moves in the plane and turns about its normal."""
    body = sphere((*position, 0), radius, material="grain", fixed=fixed)
    if not fixed:
        body.state.blockedDOFs = "zXY"
        body.state.vel, body.state.angVel = (*velocity, 0), (0, 0, spin)
    O.bodies.append(body)


O.materials.append(ViscElMat(kn=2e7, cn=2 * number("damping"), ks=2 * number("tangential_stiffness"), cs=0, density=2700, frictionAngle=math.atan(number("friction")), label="grain"))
disc((-1e-3, 0), (number("vx_1"), number("vy_1")), number("spin_1"), 1e-3)
disc((number("x_2"), number("y_2")), (-0.5, 0), number("spin_2"), number("radius_2"))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=1e-4),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(avoidGranularRatcheting=False)],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0, gravity=(0, 0, 0)),
]
O.dt = 1e-9

with open("motion.csv", "w") as out:
    print("step,id,x,y,vx,vy,omegaz", file=out)
    for step in range(0, 4000 + 1, 200):
        if step > 0:
            O.run(200, True)
        for body in O.bodies:
            x, v, w = body.state.pos, body.state.vel, body.state.angVel
            row = (O.iter, body.id + 1, x[0], x[1], v[0], v[1], w[2])
            print(",".join(map(repr, row)), file=out)
