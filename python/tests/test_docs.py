"""The programs of docs/python.md, as they stand there."""

import re
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "python.md"


def test_every_program_of_the_page_runs(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    monkeypatch.chdir(tmp_path)
    programs = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert len(programs) == 6
    names = {}
    for program in programs:
        exec(compile(program, str(PAGE), "exec"), names)  # noqa: S102
    assert (tmp_path / "out/friction.svg").exists()
    assert names["means"]["friction"].between(-0.5, 1.5).all()
    assert names["calibration"].answer == "determined"
    assert isinstance(names["scene"], dict) and (tmp_path / "out/elastic/summary.json").exists()
