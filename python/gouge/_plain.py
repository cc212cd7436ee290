"""Python's values as the native part takes them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from os import PathLike
from typing import Any, Union

from gouge._errors import ArgumentError

Scene = Union[str, "PathLike[str]", Mapping[str, Any]]
Overrides = Mapping[str, Any]


DEEPEST = 100
"""Most levels of dicts and lists within each other."""


def plain(value: Any, key: str = "", depth: int = 0) -> Any:
    """The value with NumPy's numbers and arrays as Python's, and paths as text.

    Raises
    ------
    ArgumentError: None, a set, or too many levels
    """
    if depth > DEEPEST:
        raise ArgumentError(f"{key[:60]}: more than {DEEPEST} levels within each other")
    if isinstance(value, Mapping):
        dotted = f"{key}." if key else ""
        return {str(name): plain(inner, f"{dotted}{name}", depth + 1) for name, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(inner, key, depth + 1) for inner in value]
    if value is None or isinstance(value, (set, frozenset)):
        what = "None is no value; leave the key out" if value is None else "a set has no order; use a list"
        raise ArgumentError(f"{key}: {what}", key=key, value=str(value), cause=what)
    if isinstance(value, PathLike):
        return os.fspath(value)
    return value.tolist() if hasattr(value, "tolist") else value


def plain_scene(scene: Scene) -> Any:
    """The scene, as the native part takes it."""
    return plain(scene) if isinstance(scene, Mapping) else scene


def plain_overrides(overrides: Overrides | None) -> dict[str, Any] | None:
    """The overrides, as the native part takes them."""
    return None if overrides is None else {key: plain(value, key) for key, value in overrides.items()}
