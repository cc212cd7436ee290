"""Whole runs."""

from __future__ import annotations

import json
import os
import shutil
import sys
import warnings
import weakref
from os import PathLike
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from gouge import _gouge
from gouge._errors import ArgumentError, FileError, UntrustedError
from gouge._plain import Overrides, Scene, plain_overrides, plain_scene
from gouge._program import shows_progress
from gouge._table import Table


class Run:
    """The outputs of a run in a folder. Tables are read when they are asked for.

    In a notebook, a run shows its final picture.
    """

    def __init__(self, folder: str | PathLike[str]) -> None:
        self.folder = Path(folder).absolute()
        """The folder."""
        self.account: str | None = None
        """What ``gouge run`` prints at the end: friction with its uncertainty, the balance. None for a run that was opened
        by its folder."""

    def _path(self, name: str) -> Path:
        path = self.folder / name
        if not path.exists():
            raise FileError(f"{path}: the run has no such output", file=path, cause="missing")
        return path

    @property
    def summary(self) -> dict[str, Any]:
        """``summary.json``: status, steps, energies in J, friction with its interval, warnings."""
        text = self._path("summary.json").read_text(encoding="utf-8")
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
        return Table.read(self._path("series.csv"))

    @property
    def particles(self) -> Table:
        """The final particles."""
        return Table.read(self._path("particles.csv"))

    @property
    def bonds(self) -> Table:
        """The final bonds, if the scene has bonds."""
        return Table.read(self._path("bonds.csv"))

    @property
    def breaks(self) -> Table:
        """The bonds that broke, with time in s, place in m and forces in N, if the scene has bonds."""
        return Table.read(self._path("breaks.csv"))

    @property
    def picture(self) -> str:
        """The final picture as SVG."""
        return self._path("picture.svg").read_text(encoding="utf-8")

    @property
    def page(self) -> Path:
        """The page ``run.html``."""
        return self.folder / "run.html"

    def to_pandas(self) -> Any:
        """The series as a data frame; needs pandas."""
        return self.series.to_pandas()

    def __repr__(self) -> str:
        return self.account or f"Run({str(self.folder)!r}): {self.summary['status']}"

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
    progress: whether progress is shown, on a terminal or in a notebook
    resume: continue an interrupted run, or extend a finished one to a later ``time.end``
    overwrite: replace the results of another run in this folder
    accept_untrusted: return results whose energy balance is off
    checkpoint_interval: wall time in s between checkpoints

    Ctrl-C stops the run with a checkpoint and raises KeyboardInterrupt; the same call with ``resume=True`` continues it with
    the same bits, if it has a folder. Doubts about the scene are Python's warnings.

    Raises
    ------
    SceneError: a mistake in the scene
    StateError: the state became invalid
    UntrustedError: the energy balance is off; the outputs are in the folder
    FileError: the folder cannot be written
    ArgumentError: the folder holds another run
    """
    if not checkpoint_interval >= 0.0:
        raise ArgumentError(f"checkpoint_interval = {checkpoint_interval}: must be zero or greater")
    folder = mkdtemp(prefix="gouge-") if out is None else os.path.abspath(out)
    try:
        text, doubts, account = _gouge.run(
            plain_scene(scene),
            folder,
            plain_overrides(overrides),
            resume,
            overwrite,
            checkpoint_interval,
            _bar if shows_progress(progress) else None,
        )
    except BaseException:
        if out is None:
            shutil.rmtree(folder, ignore_errors=True)
        raise
    if json.loads(text)["status"] == "untrusted" and not accept_untrusted:
        cause = "; ".join(doubts)
        message = f"the results in {folder} cannot be trusted (accept_untrusted=True returns them): {cause}"
        raise UntrustedError(message, file=Path(folder), cause=cause)
    for doubt in doubts:
        warnings.warn(doubt, stacklevel=2)
    result = Run(folder)
    result.account = account
    if out is None:
        weakref.finalize(result, shutil.rmtree, folder, ignore_errors=True)
    return result


def _bar(share: float, phase: str) -> None:
    end = "\n" if share >= 1.0 else ""
    print(f"\r{phase:12} {100 * share:3.0f} %", end=end, file=sys.stderr, flush=True)
