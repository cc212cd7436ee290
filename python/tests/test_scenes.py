"""Scenes as dicts, links, bounds of the time step."""

import _thread
import json
import os
import subprocess
import sys
import threading
import time

import gouge
import numpy as np
import pytest


def test_every_built_in_scene_is_a_dict_that_can_be_used():
    names = gouge.scenes()
    assert {"head-on", "granite-fault-small"} <= set(names)
    for name in names:
        assert gouge.scene(name)["time"]["step"] > 0.0


def test_a_dict_and_the_scene_it_came_from_have_the_same_bits():
    from_name, from_dict = (
        gouge.run(scene).series for scene in ["head-on", gouge.scene("head-on")]
    )
    assert list(from_name) == list(from_dict)
    assert all(np.array_equal(from_name[key], from_dict[key]) for key in from_name)


def test_numbers_of_numpy_count_as_numbers():
    scene = gouge.scene("head-on")
    scene["time"]["end"] = np.float64(1e-6)
    overrides = {"particles.0.velocity": np.array([0.25, 0.0]), "output.energy": np.bool_(True)}
    velocity = gouge.Simulation(scene, overrides).particles.velocity
    assert velocity[0].tolist() == [0.25, 0.0]


def test_links_are_those_of_the_command_line(command, tmp_path):
    table = gouge.links("brazilian-disc")
    (tmp_path / "links.csv").write_text(command("links", "brazilian-disc").stdout)
    expected = gouge.Table.read(tmp_path / "links.csv")
    assert list(table) == list(expected) and table.rows > 100
    assert all(np.array_equal(table[name], expected[name]) for name in table)
    assert set(table["kind"]) == {"strong"}


def test_bounds_are_those_of_the_command_line(command):
    overrides = {"contact.normal.stiffness": 1e9}
    printed = command("stability", "head-on", "--set", "contact.normal.stiffness=1e9").stdout
    assert gouge.stability("head-on", overrides) == json.loads(printed)


@pytest.mark.parametrize(
    ("scene", "overrides", "about"),
    [
        ("head-on", {"time.step": -1.0}, (None, None, "time.step", "-1.0")),
        ("head-on", {"contact.normal.law": "hertz"}, (None, None, "contact.normal.law", '"hertz"')),
        ({"time": 3}, None, (None, None, "time", "3")),
        ("nowhere.toml", None, ("nowhere.toml", None, None, None)),
    ],
)
def test_a_mistake_names_file_key_value_and_what_is_accepted(scene, overrides, about):
    with pytest.raises(gouge.SceneError) as raised:
        gouge.run(scene, overrides=overrides)
    error = raised.value
    assert (error.file, error.line, error.key, error.value) == about
    assert error.cause and isinstance(error, ValueError)


def test_a_mistake_in_a_file_names_its_line(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("[time]\nstep = 0.0\nend = 1.0\nintegrator = 'euler'\n")
    with pytest.raises(gouge.SceneError) as raised:
        gouge.Simulation(path)
    assert raised.value.file == str(path) and raised.value.cause


@pytest.mark.parametrize(
    ("scene", "words"),
    [
        ({"time": None}, "time: None is no value"),
        ({"time": {"step": object()}}, "no form in TOML"),
        ({"particles": [{"position": {1.0, 2.0}}]}, "a set has no order"),
        ({"title": 2**70}, "no form in TOML"),
    ],
)
def test_a_dict_without_a_form_in_toml_is_refused(scene, words):
    with pytest.raises(gouge.ArgumentError, match=words):
        gouge.Simulation(scene)
    with pytest.raises(gouge.ArgumentError):
        gouge.Simulation("head-on", scene)


def test_ctrl_c_stops_a_set_up():
    threading.Timer(0.3, _thread.interrupt_main).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        gouge.stability("granite-fault-small", {"setup.relax.0.duration": 0.5})
    assert time.monotonic() - began < 5.0


def test_what_the_environment_says_wrongly_is_refused():
    environment = os.environ | {"GOUGE_THREADS": "many"}
    script = "import gouge; gouge.Simulation('head-on')"
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True)
    assert "ArgumentError" in done.stderr and "GOUGE_THREADS" in done.stderr


def test_an_unknown_scene_is_refused_with_the_known_ones():
    with pytest.raises(gouge.ArgumentError, match="granite-fault-small"):
        gouge.scene("nowhere")
