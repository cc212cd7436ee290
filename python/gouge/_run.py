"""Whole runs."""

from __future__ import annotations

import json
import sys
import warnings
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from gouge import _gouge
from gouge._scenes import Overrides, Scene, plain_overrides, plain_scene
from gouge._table import Table


class Run:
    """The outputs of a run in a folder. Tables are read when they are asked for.

    In a notebook, a run shows its final picture.
    """

    def __init__(self, folder: str | PathLike[str]) -> None:
        self.folder = Path(folder)
        """The folder."""
        self._kept: TemporaryDirectory[str] | None = None

    @property
    def summary(self) -> dict[str, Any]:
        """``summary.json``: status, steps, energies in J, friction with its interval, warnings."""
        text = (self.folder / "summary.json").read_text(encoding="utf-8")
        summary: dict[str, Any] = json.loads(text)
        return summary

    @property
    def friction(self) -> float | None:
        """Coefficient of friction of a driven block; None if nothing slides."""
        friction = self.summary.get("friction")
        return None if friction is None else float(friction["coefficient"])

    @property
    def series(self) -> Table:
        """Energies in J, friction, bonds and what else the scene measures, over ``time`` in s."""
        return Table.read(self.folder / "series.csv")

    @property
    def particles(self) -> Table:
        """The final particles."""
        return Table.read(self.folder / "particles.csv")

    @property
    def bonds(self) -> Table:
        """The final bonds."""
        return Table.read(self.folder / "bonds.csv")

    @property
    def breaks(self) -> Table:
        """The bonds that broke, with time in s, place in m and forces in N."""
        return Table.read(self.folder / "breaks.csv")

    @property
    def picture(self) -> str:
        """The final picture as SVG."""
        return (self.folder / "picture.svg").read_text(encoding="utf-8")

    @property
    def page(self) -> Path:
        """The page ``run.html``."""
        return self.folder / "run.html"

    def to_pandas(self) -> Any:
        """The series as a data frame; needs pandas."""
        return self.series.to_pandas()

    def __repr__(self) -> str:
        return f"Run({str(self.folder)!r}): {self.summary['status']}"

    def _repr_html_(self) -> str:
        return self.picture


def run(
    scene: Scene,
    out: str | PathLike[str] | None = None,
    overrides: Overrides | None = None,
    progress: bool = True,
    *,
    resume: bool = False,
    overwrite: bool = False,
    accept_untrusted: bool = False,
    checkpoint_interval: float = 5.0,
) -> Run:
    """Run a scene and write its outputs into a folder, as ``gouge run`` does.

    Parameters
    ----------
    scene: a name, a path or a dict
    out: the folder; if None, a temporary one that lives as long as the result
    overrides: values of dotted keys
    progress: whether progress is shown on a terminal
    resume: continue an interrupted run, or extend a finished one to a later ``time.end``
    overwrite: replace the results of another run in this folder
    accept_untrusted: return results whose energy balance is off
    checkpoint_interval: wall time in s between checkpoints

    Ctrl-C stops the run with a checkpoint, and ``resume=True`` continues it with the same bits. Doubts about the scene are
    Python's warnings.

    Raises
    ------
    SceneError: a mistake in the scene
    StateError: the state became invalid
    UntrustedError: the energy balance is off; the outputs are in the folder
    FileError: the folder cannot be written
    ArgumentError: the folder holds another run
    """
    kept, folder = None, out
    if folder is None:
        kept = TemporaryDirectory(prefix="gouge-")
        folder = kept.name
    text, doubts = _gouge.run(
        plain_scene(scene),
        folder,
        plain_overrides(overrides),
        resume,
        overwrite,
        accept_untrusted,
        checkpoint_interval,
        _bar if progress and sys.stderr.isatty() else None,
    )
    for doubt in doubts:
        warnings.warn(doubt, stacklevel=2)
    result = Run(folder)
    result._kept = kept
    return result


def _bar(share: float, phase: str) -> None:
    end = "\n" if share >= 1.0 else ""
    print(f"\r{phase:12} {100 * share:3.0f} %", end=end, file=sys.stderr, flush=True)
