"""The command ``gouge``."""

import signal
import sys

from gouge import _gouge
from gouge._program import PROGRAM


def main() -> int:
    """Do what the command line says; the exit status."""
    # The program stops with a checkpoint by itself.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _gouge.command_line(PROGRAM, ["gouge", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
