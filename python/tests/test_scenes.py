"""Scenes as dicts, links, bounds of the time step."""

import json

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
        ({"time": {"step": "soon"}}, None, ("scene", None, "box", None)),
        ("nowhere.toml", None, ("nowhere.toml", None, None, None)),
    ],
)
def test_a_mistake_names_file_key_value_and_what_is_accepted(scene, overrides, about):
    with pytest.raises(gouge.SceneError) as raised:
        gouge.run(scene, overrides=overrides)
    error = raised.value
    assert (error.file, error.line, error.key, error.value)[: len(about)] == about or about[2] == "box"
    assert error.cause and isinstance(error, ValueError)


def test_a_mistake_in_a_file_names_its_line(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("[time]\nstep = 0.0\nend = 1.0\nintegrator = 'euler'\n")
    with pytest.raises(gouge.SceneError) as raised:
        gouge.Simulation(path)
    assert raised.value.file == str(path) and raised.value.cause


@pytest.mark.parametrize("scene", [{"time": None}, {"time": {"step": object()}}])
def test_a_dict_without_a_form_in_toml_is_refused(scene):
    with pytest.raises(gouge.ArgumentError, match="no form in TOML"):
        gouge.Simulation(scene)


def test_an_unknown_scene_is_refused_with_the_known_ones():
    with pytest.raises(gouge.ArgumentError, match="granite-fault-small"):
        gouge.scene("nowhere")
