"""Scenes and what can be said of them without running them."""

from __future__ import annotations

import json
from typing import Any

from gouge import _gouge
from gouge._plain import Overrides, Scene, plain_overrides, plain_scene
from gouge._table import Table


def scenes() -> dict[str, str]:
    """Names of the built-in scenes, each with its purpose."""
    return _gouge.scenes()


def scene(name: str) -> dict[str, Any]:
    """A built-in scene as a nested dict, to be changed and run.

    Raises
    ------
    ArgumentError: there is no such scene
    """
    return _gouge.scene(name)


def links(scene: Scene, overrides: Overrides | None = None) -> Table:
    """All contacts and bonds at t = 0, after the set-up, sorted by pair.

    The columns are those of ``links.csv``: the particles ``i`` and ``j``, the ``kind`` (``strong`` for bonds, ``weak`` for contacts), kinematics in m and m/s, forces in N
    and torques in N m. A negative normal force is repulsive.

    Raises
    ------
    SceneError: a mistake in the scene
    StateError: a state that becomes invalid in the set-up
    """
    return Table(_gouge.links(plain_scene(scene), plain_overrides(overrides)))


def stability(scene: Scene, overrides: Overrides | None = None) -> dict[str, Any]:
    """The bounds of the time step in s, as ``gouge stability`` prints them.

    Raises
    ------
    SceneError: a mistake in the scene
    StateError: a state that becomes invalid in the set-up
    """
    text = _gouge.stability(plain_scene(scene), plain_overrides(overrides))
    bounds: dict[str, Any] = json.loads(text)
    return bounds
