"""Scenes and the command line for the tests."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

SWEEP = {
    "scene": "head-on",
    "axis": [{"key": "contact.normal.damping", "values": [0.0, 10.0]}],
    "observe": [{"quantity": "restitution"}],
}


@pytest.fixture(autouse=True)
def ctrl_c():
    """Lets Ctrl-C raise KeyboardInterrupt: a shell that starts the tests in the background has told them to ignore it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def command(tmp_path):
    """The command ``gouge`` in a folder of its own; returns the finished process."""

    def run(*arguments, status=0, **options):
        done = subprocess.run(
            [sys.executable, "-m", "gouge", *map(str, arguments)],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
            **options,
        )
        assert done.returncode == status, done.stderr
        return done

    return run


@pytest.fixture
def verify_on_path():
    """Skips a test if the checks are not built."""
    name = "gouge-verify"
    folders = [Path(folder) for folder in os.environ["PATH"].split(os.pathsep)]
    if not any((folder / name).exists() for folder in [*folders, Path(sys.executable).parent]):
        pytest.skip("the checks are not installed")
