"""Stepping a scene from Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gouge import _gouge
from gouge._plain import Overrides, Scene, plain_overrides, plain_scene
from gouge._table import Table

if TYPE_CHECKING:
    from typing import Self


class Particles:
    """The particles of a simulation at the moment at which a column is read. Each column is a new array."""

    def __init__(self, simulation: _gouge.Simulation) -> None:
        self._simulation = simulation

    def __len__(self) -> int:
        return len(self._simulation)

    @property
    def position(self) -> NDArray[np.float64]:
        """Centres in m, shape (n, 2)."""
        return self._simulation.column("position")

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities in m/s, shape (n, 2)."""
        return self._simulation.column("velocity")

    @property
    def force(self) -> NDArray[np.float64]:
        """Forces of the latest evaluation in N, shape (n, 2)."""
        return self._simulation.column("force")

    @property
    def torque(self) -> NDArray[np.float64]:
        """Torques of the latest evaluation in N m, counter-clockwise, shape (n,)."""
        return self._simulation.column("torque")

    @property
    def angle(self) -> NDArray[np.float64]:
        """Angles in rad, counter-clockwise, never wrapped, shape (n,)."""
        return self._simulation.column("angle")

    @property
    def angular_velocity(self) -> NDArray[np.float64]:
        """Angular velocities in rad/s, shape (n,)."""
        return self._simulation.column("angular_velocity")

    @property
    def radius(self) -> NDArray[np.float64]:
        """Radii in m, shape (n,)."""
        return self._simulation.column("radius")

    @property
    def mass(self) -> NDArray[np.float64]:
        """Masses in kg, shape (n,)."""
        return self._simulation.column("mass")

    @property
    def moment_of_inertia(self) -> NDArray[np.float64]:
        """Moments of inertia in kg m^2, shape (n,)."""
        return self._simulation.column("moment_of_inertia")

    @property
    def role(self) -> NDArray[np.str_]:
        """Roles, ``free``, ``driven`` or ``fixed``, shape (n,)."""
        names, codes = self._simulation.roles()
        return np.array(names)[codes]

    def to_table(self) -> Table:
        """All columns but forces, vectors as ``x``, ``y``, ``vx`` and ``vy``."""
        (x, y), (vx, vy) = self.position.T, self.velocity.T
        scalars = ["angle", "angular_velocity", "radius", "mass", "moment_of_inertia", "role"]
        columns = {"x": x, "y": y, "vx": vx, "vy": vy}
        return Table(columns | {name: getattr(self, name) for name in scalars})

    def to_pandas(self) -> Any:
        """As :meth:`to_table`, as a data frame; needs pandas."""
        return self.to_table().to_pandas()


class Simulation(_gouge.Simulation):
    """A scene that is stepped from Python, from t = 0 on.

    The set-up of the scene is run first, which may take a while. In a notebook, a simulation shows its picture.

    Parameters
    ----------
    scene: a name, a path or a dict
    overrides: values of dotted keys

    Raises
    ------
    SceneError: a mistake in the scene
    StateError: a state that becomes invalid in the set-up

    >>> import gouge
    >>> simulation = gouge.Simulation("head-on")
    >>> simulation.step(1000)
    >>> simulation.particles.velocity.shape
    (2, 2)
    """

    def __new__(cls, scene: Scene, overrides: Overrides | None = None) -> Self:
        return super().__new__(cls, plain_scene(scene), plain_overrides(overrides))

    @property
    def particles(self) -> Particles:
        """The particles."""
        return Particles(self)

    def contacts(self) -> Table:
        """All contacts, sorted by pair, with the columns of :func:`gouge.links`."""
        return Table(self.interactions("contact"))

    def bonds(self) -> Table:
        """All bonds, sorted by pair, with the columns of :func:`gouge.links`."""
        return Table(self.interactions("bond"))

    def __repr__(self) -> str:
        return f"Simulation of {len(self)} particles at {self.time:.6g} s"

    def _repr_html_(self) -> str:
        return self.picture()
