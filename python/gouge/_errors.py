"""Exceptions. Each carries what it is about."""

from __future__ import annotations

from os import PathLike


class Error(Exception):
    """Any failure of gouge.

    Attributes
    ----------
    file: the file, folder or override at fault, if any
    line: the line of the file, counted from one, if a single one is at fault
    key: the dotted key of a scene, if any
    value: the value found there, if any
    cause: what would be accepted, or what went wrong
    """

    def __init__(
        self,
        message: str,
        *,
        file: str | PathLike[str] | None = None,
        line: int | None = None,
        key: str | None = None,
        value: str | None = None,
        cause: str | None = None,
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.key = key
        self.value = value
        self.cause = cause


class SceneError(Error, ValueError):
    """A scene, a sweep file or a calibration file that cannot be used."""


class ArgumentError(Error, ValueError):
    """An argument that cannot be used."""


class FileError(Error, OSError):
    """A file that cannot be read or written, or a checkpoint that cannot be continued."""


class StateError(Error, ArithmeticError):
    """The state became invalid, mostly because the time step is too large (see :func:`gouge.stability`)."""


class UntrustedError(Error):
    """A run finished, but its energy balance shows that the results cannot be trusted. They are kept in the folder ``file``,
    and ``cause`` says how far the balance is off."""
