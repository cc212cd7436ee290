"""Scenes and what can be said of them without running them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike
from typing import Any, Union

from gouge import _gouge
from gouge._table import Table

Scene = Union[str, "PathLike[str]", Mapping[str, Any]]
Overrides = Mapping[str, Any]


def plain(value: Any) -> Any:
    """The value with NumPy's numbers and arrays as Python's."""
    if isinstance(value, Mapping):
        return {str(key): plain(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(inner) for inner in value]
    return value.tolist() if hasattr(value, "tolist") else value


def plain_scene(scene: Scene) -> Any:
    """The scene, as the native part takes it."""
    return plain(scene) if isinstance(scene, Mapping) else scene


def plain_overrides(overrides: Overrides | None) -> dict[str, Any] | None:
    """The overrides, as the native part takes them."""
    return None if overrides is None else plain(overrides)


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
