"""Whole runs."""

import _thread
import subprocess
import sys
import threading
import time

import gouge
import numpy as np
import pytest


def test_a_run_has_the_bits_of_the_command_line(command, tmp_path):
    overrides = {"time.end": 1e-5, "contact.normal.damping": 3.0}
    run = gouge.run("head-on", tmp_path / "python", overrides)
    command("run", "head-on", "--out", "line", "--set", "time.end=1e-5", "--set", "contact.normal.damping=3.0")
    for name in ["series.csv", "particles.csv"]:
        assert (run.folder / name).read_bytes() == (tmp_path / "line" / name).read_bytes()
    assert run.summary["status"] == "done"


def test_a_run_without_a_folder_is_kept_as_long_as_it_is_used():
    run = gouge.run("head-on")
    folder = run.folder
    assert folder.exists() and run.page.exists()
    del run
    assert not folder.exists()


def test_results_are_tables():
    run = gouge.run("direct-tension", overrides={"time.end": 2e-5, "setup.seed": 5})
    assert run.series["time"][-1] == pytest.approx(2e-5)
    assert run.bonds.rows > 100 and run.breaks.rows >= 0
    frame = run.to_pandas()
    assert list(frame.columns) == list(run.series)
    assert run._repr_html_().startswith("<svg")
    assert repr(run) == run.account and run.account.startswith("status          done")
    with pytest.raises(gouge.FileError):
        gouge.run("head-on").bonds
    with pytest.raises(gouge.FileError):
        gouge.Run("nowhere").summary


def test_a_finished_run_is_not_replaced(tmp_path):
    gouge.run("head-on", tmp_path)
    with pytest.raises(gouge.ArgumentError) as raised:
        gouge.run("head-on", tmp_path, {"contact.normal.damping": 1.0})
    assert "overwrite=True" in str(raised.value)
    gouge.run("head-on", tmp_path, {"contact.normal.damping": 1.0}, overwrite=True)


def test_results_that_cannot_be_trusted_are_an_error_unless_accepted(tmp_path):
    overrides = {"time.step": 8e-7, "time.integrator": "euler"}
    with pytest.raises(gouge.UntrustedError) as raised:
        gouge.run("head-on", tmp_path, overrides)
    assert raised.value.file == tmp_path and "%" in raised.value.cause
    with pytest.raises(gouge.UntrustedError) as raised:
        gouge.run("head-on", overrides=overrides)
    assert gouge.Run(raised.value.file).summary["status"] == "untrusted"
    with pytest.warns(UserWarning):
        run = gouge.run("head-on", tmp_path / "other", overrides, accept_untrusted=True)
    assert run.summary["status"] == "untrusted"


def test_an_invalid_state_is_an_error_with_its_cause():
    with pytest.raises(gouge.StateError) as raised:
        gouge.run("granite-fault-small", overrides={"time.step": 1e-6, "setup.press.0.step": 1e-6})
    assert raised.value.cause


def test_ctrl_c_stops_with_a_checkpoint_that_continues_with_the_same_bits(tmp_path):
    overrides = {"time.end": 5e-4, "time.step": 1e-10, "output.interval": 1e-5}
    timer = threading.Timer(0.4, _thread.interrupt_main)
    timer.start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        gouge.run("head-on", tmp_path / "stopped", overrides)
    assert time.monotonic() - began < 5.0
    overrides["time.end"] = 2e-4
    stopped = gouge.run("head-on", tmp_path / "whole", overrides)
    overrides["time.end"] = 5e-4
    whole = gouge.run("head-on", tmp_path / "whole", overrides, resume=True)
    continued = gouge.run("head-on", tmp_path / "stopped", overrides, resume=True)
    assert stopped.summary["status"] == "done"
    for name in ["series.csv", "particles.csv"]:
        assert (whole.folder / name).read_bytes() == (continued.folder / name).read_bytes()


def test_an_exception_of_the_progress_is_raised(tmp_path):
    def progress(share, phase):
        raise LookupError(phase)

    from gouge import _gouge

    with pytest.raises(LookupError):
        _gouge.run("head-on", tmp_path, {"time.step": 1e-10}, progress=progress)
    with pytest.raises(gouge.ArgumentError):
        gouge.run("head-on", checkpoint_interval=-1.0)


def test_other_threads_go_on_while_a_run_goes_on():
    ticks = []
    over = threading.Event()

    def tick():
        while not over.wait(0.01):
            ticks.append(time.monotonic())

    ticker = threading.Thread(target=tick)
    ticker.start()
    began = time.monotonic()
    gouge.run("head-on", overrides={"time.end": 3e-4, "time.step": 1e-9})
    lasted = time.monotonic() - began
    over.set()
    ticker.join()
    assert len(ticks) > 20 * lasted


def test_progress_is_shown_on_a_terminal_only(tmp_path):
    script = f"import gouge; gouge.run('head-on', {str(tmp_path / 'out')!r})"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stderr == "" and done.stdout == ""


def test_a_table_keeps_words_and_marks_missing_numbers(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("name,n,x\na,1,1.5\nb,2,\n")
    table = gouge.Table.read(path)
    assert table["name"].tolist() == ["a", "b"] and table["n"].dtype.kind == "i"
    assert table["x"][0] == 1.5 and np.isnan(table["x"][1])
    assert table.to_pandas().shape == (2, 3)
