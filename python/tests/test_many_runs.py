"""Sweeps, calibrations, the verification and the command."""

import json
import signal
import subprocess
import sys
import time

import gouge
import pytest
from conftest import SWEEP


def test_a_sweep_from_a_dict_has_the_rows_of_the_command_line(command, tmp_path):
    sweep = gouge.sweep(SWEEP, tmp_path / "python", jobs=2)
    command("sweep", tmp_path / "python" / "sweep.toml", "--out", "line", "--quiet")
    line = gouge.Sweep(tmp_path / "line").runs
    for column in ["contact.normal.damping", "status", "restitution"]:
        assert sweep.runs[column].tolist() == line[column].tolist()
    elastic, damped = sweep.runs["restitution"]
    assert elastic == pytest.approx(1.0, abs=1e-3) and damped < elastic
    assert sweep.page.exists() and sweep.to_pandas().shape[0] == 2


def test_scenes_and_overrides_of_a_sweep_may_be_dicts(tmp_path):
    scene = gouge.scene("head-on")
    scene["contact"]["normal"]["damping"] = 10.0
    axis = {"key": "time.end", "values": [1e-5, 1.2e-5]}
    sweep = gouge.sweep({**SWEEP, "scene": scene, "axis": [axis], "set": {"output.energy": True}}, tmp_path)
    damped = gouge.sweep(SWEEP, tmp_path / "other").runs["restitution"][1]
    assert sweep.runs["restitution"].tolist() == pytest.approx([damped] * 2, abs=1e-6)
    assert "2 done" in repr(sweep)


def test_runs_of_a_sweep_that_are_refused_are_told(tmp_path):
    axis = {"key": "contact.normal.damping", "values": [1.0, -1.0]}
    with pytest.warns(UserWarning, match="1 of 2 runs are not done.*finite number, zero or greater"):
        gouge.sweep(SWEEP | {"axis": [axis]}, tmp_path)


def test_a_mistake_in_a_sweep_names_file_line_and_key(tmp_path):
    path = tmp_path / "sweep.toml"
    path.write_text('scene = "head-on"\n\n[[axis]]\nkey = "time.step"\nvalues = []\n')
    with pytest.raises(gouge.SceneError) as raised:
        gouge.sweep(path, tmp_path / "out")
    error = raised.value
    assert error.file == str(path) and error.line and error.key == "axis.values"
    with pytest.raises(gouge.ArgumentError, match="jobs"):
        gouge.sweep(path, tmp_path / "out", jobs=0)


def test_a_sweep_beyond_its_budget_is_refused(tmp_path):
    with pytest.raises(gouge.ArgumentError, match="core_hours"):
        gouge.sweep(SWEEP | {"budget": {"core_hours": 1e-12}}, tmp_path)


def test_a_calibration_answers_and_refutation_is_an_answer(tmp_path):
    target = {"quantity": "restitution", "sd": 0.02, "source": "made up for this test"}
    file = {
        "title": "damping",
        "parameter": [{"key": "contact.normal.damping", "range": [0.5, 20.0]}],
        "test": [{"name": "rebound", "scene": "head-on", "set": ["time.end=12e-6"], "observe": [{"quantity": "restitution"}]}],
        "target": [target | {"value": 0.6}],
        "design": {"points": 12, "waves": 1, "predictive": 2},
    }
    found = gouge.calibrate(file, tmp_path / "found")
    assert found.answer == "determined", found.account
    damping = found.material["contact"]["normal"]["damping"]
    run = gouge.run("head-on", overrides={"time.end": 12e-6, "contact.normal.damping": damping})
    kinetic = run.series["kinetic"]
    assert (kinetic[-1] / kinetic[0]) ** 0.5 == pytest.approx(0.6, abs=0.02)
    assert found.posterior.rows > 100 and found.runs.rows >= 12
    refuted = gouge.calibrate(file | {"target": [target | {"value": 1.5}]}, tmp_path / "refuted")
    assert refuted.answer == "refuted" and refuted.material is None


def test_a_folder_that_cannot_be_written_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    for out in [tmp_path / "file", tmp_path / "file" / "below"]:
        with pytest.raises(gouge.FileError):
            gouge.sweep(SWEEP, out)


def test_a_module_of_the_working_directory_is_not_started(tmp_path, monkeypatch):
    if sys.version_info < (3, 11):
        pytest.skip("needs python -P")
    (tmp_path / "gouge.py").write_text("raise SystemExit(7)")
    monkeypatch.chdir(tmp_path)
    assert gouge.sweep(SWEEP, "-out").runs["status"].tolist() == ["done", "done"]


def test_the_checks_run(verify_on_path):
    report = gouge.verify(only="identities")
    assert report["checks"] and all(check["status"] == "pass" for check in report["checks"])
    with pytest.raises(gouge.ArgumentError, match="no check"):
        gouge.verify(only="no-such-check")


def test_the_command_ends_with_the_status_of_the_program(command, tmp_path):
    assert "gouge " in command("--version").stdout
    assert "head-on" in command("scenes").stdout
    said = command("run", "nowhere", "--out", "x", status=2).stderr
    assert said.startswith("gouge: nowhere: must be a readable scene file")
    command("nonsense", status=2)
    command("run", "head-on", "--out", tmp_path / "out", "--quiet")
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["status"] == "done"


def test_ctrl_c_stops_the_command_with_a_checkpoint(tmp_path):
    arguments = ["run", "head-on", "--out", str(tmp_path), "--set", "time.end=1.0", "--quiet"]
    process = subprocess.Popen([sys.executable, "-m", "gouge", *arguments], stderr=subprocess.PIPE, text=True)
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert process.returncode == 130 and "--resume" in said
