"""The programs of docs/python.md, as they stand there."""

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "python.md"


def programs():
    """The programs of the page."""
    return re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


def test_every_program_of_the_page_runs(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    monkeypatch.chdir(tmp_path)
    assert len(programs()) == 6
    names = {}
    for program in programs():
        exec(compile(program, str(PAGE), "exec"), names)  # noqa: S102
    assert (tmp_path / "out/friction.svg").exists()
    assert names["means"]["friction"].between(-0.5, 1.5).all()
    assert names["calibration"].answer == "determined"
    assert isinstance(names["scene"], dict) and (tmp_path / "out/elastic/summary.json").exists()


@pytest.mark.skipif("GOUGE_TEST_INSTALL" not in os.environ, reason="compiles everything")
def test_the_commands_of_the_page_lead_from_a_clone_to_a_plot_in_a_notebook(tmp_path):
    page = PAGE.read_text(encoding="utf-8")
    commands = re.search(r"```sh install\n(.*?)```", page, re.DOTALL).group(1).splitlines()
    assert commands[-1] == "env/bin/jupyter notebook"
    subprocess.run(["git", "clone", "-q", ROOT, tmp_path / "clone"], check=True)
    cell = {"cell_type": "code", "id": "plot", "metadata": {}, "outputs": [], "execution_count": None}
    notebook = {"metadata": {}, "nbformat": 4, "nbformat_minor": 5}
    notebook["cells"] = [cell | {"source": programs()[0]}]
    (tmp_path / "clone/plot.ipynb").write_text(json.dumps(notebook))
    commands[-1] = "env/bin/jupyter nbconvert --to notebook --execute plot.ipynb"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    for command in commands:
        subprocess.run(command, shell=True, check=True, cwd=tmp_path / "clone", env=environment)
    assert (tmp_path / "clone/out/friction.svg").exists()
