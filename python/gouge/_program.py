"""How the command ``gouge`` is started, and whether progress is shown."""

import sys

# A file of the working directory must not take the place of a module.
PROGRAM = [sys.executable, *(["-P"] if sys.version_info >= (3, 11) else []), "-m", "gouge"]


def shows_progress(wanted: bool) -> bool:
    """Whether progress is wanted and somebody sees it: on a terminal, or in a notebook."""
    is_terminal = getattr(sys.stderr, "isatty", None)
    return wanted and ("ipykernel" in sys.modules or (is_terminal is not None and is_terminal()))
