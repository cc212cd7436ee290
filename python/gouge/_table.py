"""Tables: columns of equal length by name."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gouge import _gouge

if TYPE_CHECKING:
    import pandas

_gouge.load_numpy()


class Table(dict[str, NDArray[Any]]):
    """A dict from the names of columns to one-dimensional NumPy arrays of equal length: numbers, or words."""

    def __init__(self, columns: Mapping[str, Iterable[Any]]) -> None:
        super().__init__({name: np.asarray(column) for name, column in columns.items()})

    @classmethod
    def read(cls, path: str | PathLike[str]) -> Table:
        """The table of a CSV file with a header. Columns in which all filled cells are numbers become numbers; empty
        cells among them are NaN."""
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.reader(file)
            names = next(rows, [])
            columns = list(zip(*rows)) or [()] * len(names)
        return cls({name: _converted(column) for name, column in zip(names, columns)})

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(next(iter(self.values()), ()))

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a data frame; needs pandas."""
        import pandas

        return pandas.DataFrame(self)

    def __repr__(self) -> str:
        return f"Table of {self.rows} rows: {', '.join(self)}"

    def _repr_html_(self) -> str:
        try:
            return str(self.to_pandas()._repr_html_())
        except ImportError:
            return repr(self)


def _converted(column: tuple[str, ...]) -> NDArray[Any]:
    if column and all(cell.lstrip("-").isdigit() for cell in column):
        return np.array([int(cell) for cell in column])
    try:
        return np.array([float(cell) if cell else np.nan for cell in column])
    except ValueError:
        return np.array(column)
