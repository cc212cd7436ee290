"""A verified discrete element model of shearing brittle surfaces.

All quantities are in SI units. A scene is the name of a built-in scene, a path of a scene file, or a nested dict as
:func:`scene` returns it; ``overrides`` are a dict from dotted keys to values, such as
``{"contact.tangential.friction": 0.5}``. Results have the same bits as those of the command ``gouge``.

>>> import gouge
>>> run = gouge.run("head-on", overrides={"contact.normal.damping": 0.0})
>>> run.summary["status"]
'done'
"""

from gouge._errors import (
    ArgumentError,
    Error,
    FileError,
    Interrupted,
    SceneError,
    StateError,
    UntrustedError,
)
from gouge._many_runs import Calibration, Sweep, calibrate, sweep, verify
from gouge._scenes import links, scene, scenes, stability
from gouge._run import Run, run
from gouge._simulation import Particles, Simulation
from gouge._table import Table
from gouge._gouge import version

__version__ = version().split(" ")[0]

__all__ = [
    "ArgumentError",
    "Calibration",
    "Error",
    "FileError",
    "Interrupted",
    "Particles",
    "Run",
    "SceneError",
    "Simulation",
    "StateError",
    "Sweep",
    "Table",
    "UntrustedError",
    "calibrate",
    "links",
    "run",
    "scene",
    "scenes",
    "stability",
    "sweep",
    "verify",
    "version",
]
