"""A verified discrete element model of shearing brittle surfaces.

All quantities are in SI units. A scene is the name of a built-in scene, a path of a scene file, or a nested dict as
:func:`scene` returns it; ``overrides`` are a dict from dotted keys to values, such as
``{"contact.tangential.friction": 0.5}``. Results have the same bits as those of the command ``gouge``.

>>> import gouge
>>> run = gouge.run("head-on", overrides={"contact.normal.damping": 0.0})
>>> run.summary["status"]
'done'

``help(gouge.run)``, ``help(gouge.Simulation)`` and so on describe each of the names in ``gouge.__all__``.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gouge._errors import (
        ArgumentError,
        Error,
        FileError,
        SceneError,
        StateError,
        UntrustedError,
    )
    from gouge._gouge import version
    from gouge._many_runs import Calibration, Sweep, calibrate, sweep, verify
    from gouge._run import Run, run
    from gouge._scenes import links, scene, scenes, stability
    from gouge._simulation import Particles, Simulation
    from gouge._table import Table

    __version__: str

__all__ = [
    "ArgumentError",
    "Calibration",
    "Error",
    "FileError",
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

_MODULES = {
    "_errors": ["ArgumentError", "Error", "FileError", "SceneError", "StateError", "UntrustedError"],
    "_gouge": ["version"],
    "_many_runs": ["Calibration", "Sweep", "calibrate", "sweep", "verify"],
    "_run": ["Run", "run"],
    "_scenes": ["links", "scene", "scenes", "stability"],
    "_simulation": ["Particles", "Simulation"],
    "_table": ["Table"],
}


def __getattr__(name: str) -> Any:
    # The command starts without NumPy: a sweep starts it for every run.
    if name == "__version__":
        return import_module("gouge._gouge").version().split(" ")[0]
    for module, names in _MODULES.items():
        if name in names:
            value = getattr(import_module(f"gouge.{module}"), name)
            globals()[name] = value
            return value
    raise AttributeError(f"module 'gouge' has no attribute {name!r}")


def __dir__() -> list[str]:
    return [*__all__, "__version__"]
