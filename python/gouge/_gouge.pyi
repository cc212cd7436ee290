"""The native part of the package."""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

def version() -> str: ...
def load_numpy() -> None: ...
def scenes() -> dict[str, str]: ...
def scene(name: str) -> dict[str, Any]: ...
def toml(mapping: Mapping[str, Any]) -> str: ...
def toml_value(value: Any) -> str: ...
def dict_of_toml(text: str) -> dict[str, Any]: ...
def links(scene: Any, overrides: dict[str, Any] | None = None) -> dict[str, Any]: ...
def stability(scene: Any, overrides: dict[str, Any] | None = None) -> str: ...
def run(
    scene: Any,
    out: str | PathLike[str],
    overrides: dict[str, Any] | None = None,
    resume: bool = False,
    overwrite: bool = False,
    checkpoint_interval: float = 5.0,
    progress: Callable[[float, str], None] | None = None,
) -> tuple[str, list[str], str]: ...
def command_line(program: Sequence[str], arguments: Sequence[str]) -> int: ...
def sweep(
    program: Sequence[str],
    file: str | PathLike[str],
    out: str | PathLike[str],
    jobs: int,
    progress: Callable[[int, int], None] | None = None,
) -> None: ...
def calibrate(
    program: Sequence[str],
    file: str | PathLike[str],
    out: str | PathLike[str],
    jobs: int,
    progress: Callable[[int, int], None] | None = None,
) -> tuple[str, str]: ...

class Simulation:
    def __new__(cls, scene: Any, overrides: dict[str, Any] | None = None) -> Self: ...
    def __len__(self) -> int: ...
    @property
    def time(self) -> float:
        """Time in s."""
    @property
    def steps(self) -> int:
        """Number of steps since t = 0."""
    @property
    def time_step(self) -> float:
        """The time step in s."""
    @property
    def end(self) -> float:
        """Time in s at which a run of the scene ends; steps may go on beyond it."""
    def step(self, n: int = 1) -> None:
        """Advance by n steps. Other threads go on meanwhile, and Ctrl-C stops between two steps.

        Raises StateError if the state becomes invalid.
        """
    def column(self, name: str) -> NDArray[np.float64]:
        """A column of particle data, see Particles."""
    def roles(self) -> tuple[list[str], NDArray[np.uint8]]:
        """Names of roles, and for each particle the place of its role among them."""
    def interactions(self, kind: str) -> dict[str, Any]:
        """Columns of all interactions of a kind, "contact" or "bond", or of "all"."""
    def energy(self) -> dict[str, float]:
        """Terms of the energy balance in J; heat, work and residual are zero if the scene does not keep them."""
    def friction(self) -> dict[str, float]:
        """Coefficients of friction of the driven grains: "load", from the driving force, and "feedback", from the reaction to
        it; NaN without a driven grain.
        """
    def checkpoint(self) -> bytes:
        """The whole state, for restore."""
    def restore(self, bytes: bytes) -> None:
        """Return to a state of the same scene that checkpoint gave; later steps have the same bits.

        Raises ArgumentError for a state of another scene, or for damaged bytes.
        """
    def picture(self) -> str:
        """The present state as SVG."""
