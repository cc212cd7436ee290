"""Many runs: sweeps, calibrations, the verification."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import warnings
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from gouge import _gouge
from gouge._errors import ArgumentError, Error, FileError
from gouge._plain import plain
from gouge._program import PROGRAM, shows_progress
from gouge._table import Table


class Sweep:
    """A sweep in a folder."""

    def __init__(self, folder: str | PathLike[str]) -> None:
        self.folder = Path(folder).absolute()
        """The folder."""

    @property
    def runs(self) -> Table:
        """``runs.csv``: a row per run, with its axes, its status, its observations and its cost."""
        return Table.read(self.folder / "runs.csv")

    @property
    def page(self) -> Path:
        """The page ``sweep.html``."""
        return self.folder / "sweep.html"

    def to_pandas(self) -> Any:
        """The runs as a data frame; needs pandas."""
        return self.runs.to_pandas()

    def __repr__(self) -> str:
        statuses = self.runs["status"].tolist()
        counts = (f"{statuses.count(status)} {status}" for status in sorted(set(statuses)))
        return f"Sweep({str(self.folder)!r}): {', '.join(counts)}"


class Calibration:
    """A calibration in a folder."""

    def __init__(self, folder: str | PathLike[str], answer: str, account: str) -> None:
        self.folder = Path(folder).absolute()
        """The folder."""
        self._answer, self._account = answer, account

    @property
    def answer(self) -> str:
        """``determined``, ``combinations``, ``undetermined``, ``unresolved`` or ``refuted``."""
        return self._answer

    @property
    def account(self) -> str:
        """What ``gouge calibrate`` prints: answer, parameters with intervals, targets."""
        return self._account

    @property
    def material(self) -> dict[str, Any] | None:
        """The best values under their keys, as nested dicts; None unless something is determined."""
        path = self.folder / "material.toml"
        return _gouge.dict_of_toml(path.read_text(encoding="utf-8")) if path.exists() else None

    @property
    def posterior(self) -> Table:
        """Points of the posterior with their weights."""
        return Table.read(self.folder / "posterior.csv")

    @property
    def runs(self) -> Table:
        """Every run."""
        return Table.read(self.folder / "runs.csv")

    @property
    def page(self) -> Path:
        """The page ``calibration.html``."""
        return self.folder / "calibration.html"

    def __repr__(self) -> str:
        return self.account


def sweep(
    file: str | PathLike[str] | Mapping[str, Any],
    out: str | PathLike[str],
    jobs: int | None = None,
    progress: bool = True,
) -> Sweep:
    """Run a scene with every combination of some values, as ``gouge sweep`` does.

    Parameters
    ----------
    file: a sweep file, or its content as a dict (``docs/studies.md`` describes the keys); in a dict, ``scene`` may be a
        dict and ``set`` a dict of overrides, and paths are relative to the working directory
    out: the folder; the same call continues a sweep that was stopped
    jobs: number of runs at a time; as many as there are cores if None
    progress: whether progress is shown, on a terminal or in a notebook

    Raises
    ------
    SceneError: a mistake in the file
    ArgumentError: a sweep beyond its budget, or without runs
    FileError: a folder that cannot be written
    """
    result = Sweep(out)
    path = _file(file, result.folder, "sweep.toml")
    _gouge.sweep(PROGRAM, path, result.folder, _jobs(jobs), _counter(progress))
    runs = result.runs
    bad = [cause for status, cause in zip(runs["status"], runs["cause"]) if status != "done"]
    if bad:
        warnings.warn(f"{len(bad)} of {runs.rows} runs are not done; the first: {bad[0]}", stacklevel=2)
    return result


def calibrate(
    file: str | PathLike[str] | Mapping[str, Any],
    out: str | PathLike[str],
    jobs: int | None = None,
    progress: bool = True,
) -> Calibration:
    """Find the parameters that agree with what was measured, as ``gouge calibrate`` does.

    Parameters
    ----------
    file: a calibration file, the name of a built-in calibration, or the content of a file as a dict
        (``docs/calibration.md`` describes the keys; scenes and overrides as in :func:`sweep`)
    out: the folder; the same call continues a calibration that was stopped
    jobs: number of runs at a time; as many as there are cores if None
    progress: whether progress is shown, on a terminal or in a notebook

    A refuted model is an answer, not an exception.

    Raises
    ------
    SceneError: a mistake in the file
    ArgumentError: a calibration beyond its budget, or a folder that holds another one
    FileError: a folder that cannot be written
    """
    folder = Path(out).absolute()
    path = Path(str(file)) if _is_builtin(file) else _file(file, folder, "calibration.toml")
    answer, account = _gouge.calibrate(PROGRAM, path, folder, _jobs(jobs), _counter(progress))
    return Calibration(folder, answer, account)


def verify(only: str | None = None, out: str | PathLike[str] | None = None) -> dict[str, Any]:
    """Run the checks, as ``gouge verify`` does; the content of ``report.json``.

    Parameters
    ----------
    only: run only checks whose identifier contains this text
    out: folder of the reports; if None, they are not kept

    Raises
    ------
    Error: the checks are not installed (``cargo install --path validation``), or nothing matches
    """
    with TemporaryDirectory(prefix="gouge-") as temporary:
        folder = Path(temporary if out is None else out)
        report = folder / "report.json"
        report.unlink(missing_ok=True)
        command = [*PROGRAM, "verify", "--out", str(folder)]
        command += ["--only", only] if only is not None else []
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1) or not report.exists():
            kind = ArgumentError if done.returncode == 2 else Error
            message = done.stderr.strip().removeprefix("gouge: ")
            raise kind(message, cause=message)
        content: dict[str, Any] = json.loads(report.read_text(encoding="utf-8"))
        return content


def _is_builtin(file: Any) -> bool:
    """Whether a calibration is the name of a built-in one, as far as the working directory tells."""
    return isinstance(file, str) and not Path(file).exists()


def _file(file: Any, folder: Path, name: str) -> Path:
    """The path of a file; that of a dict is written into the folder."""
    if not isinstance(file, Mapping):
        return Path(file)
    content = plain(file)
    try:
        return _write(content, folder, name)
    except OSError as error:
        raise FileError(f"cannot write into {folder}: {error}", file=folder, cause=str(error)) from None


def _write(content: dict[str, Any], folder: Path, name: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    tests = content.get("test", [])
    for number, table in enumerate([content, *(tests if isinstance(tests, list) else [])]):
        if isinstance(table, dict):
            _write_scene(table, folder / f"scene-{number}.toml")
    path = folder / name
    path.write_text(_gouge.toml(content), encoding="utf-8")
    return path


def _write_scene(table: dict[str, Any], path: Path) -> None:
    """Replace the scene of a table by a path, and a dict of overrides by a list."""
    scene, overrides = table.get("scene"), table.get("set")
    if isinstance(scene, dict):
        path.write_text(_gouge.toml(scene), encoding="utf-8")
        table["scene"] = path.name
    elif isinstance(scene, str) and Path(scene).is_file():
        table["scene"] = str(Path(scene).absolute())
    if isinstance(overrides, dict):
        table["set"] = [f"{key}={_gouge.toml_value(value)}" for key, value in overrides.items()]


def _jobs(jobs: int | None) -> int:
    if jobs is not None and jobs < 1:
        raise ArgumentError(f"jobs = {jobs}: must be 1 or greater", key="jobs", value=str(jobs))
    return jobs or os.cpu_count() or 1


def _counter(progress: bool) -> Any:
    return _count if shows_progress(progress) else None


def _count(ended: int, runs: int) -> None:
    end = "\n" if ended == runs else ""
    print(f"\r{ended} of {runs} runs done", end=end, file=sys.stderr, flush=True)
