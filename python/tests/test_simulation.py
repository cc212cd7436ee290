"""Stepping from Python."""

import _thread
import os
import subprocess
import sys
import threading
import time

import gouge
import numpy as np
import pytest


def test_steps_have_the_bits_of_a_run():
    run = gouge.run("oblique")
    simulation = gouge.Simulation("oblique")
    while simulation.time < simulation.end:
        simulation.step()
    assert simulation.steps == run.summary["steps"]
    x, y = simulation.particles.position.T
    assert np.array_equal(x, run.particles["x"]) and np.array_equal(y, run.particles["y"])


def test_a_set_up_is_run_first():
    overrides = {"setup.relax.0.duration": 1e-5, "setup.press.0.duration": 1e-5}
    simulation = gouge.Simulation("granite-fault-small", overrides)
    assert simulation.time == 0.0 and len(simulation) > 100
    bonds = simulation.bonds()
    assert bonds.rows > len(simulation) and set(bonds["kind"]) == {"strong"}
    assert set(simulation.particles.role) == {"free", "driven", "fixed"}
    assert simulation.friction()["load"] == pytest.approx(0.0, abs=0.2)


def test_columns_have_their_shapes_and_are_copies():
    simulation = gouge.Simulation("head-on")
    particles = simulation.particles
    for name in ["position", "velocity", "force"]:
        assert getattr(particles, name).shape == (2, 2)
    for name in ["angle", "angular_velocity", "radius", "mass", "moment_of_inertia", "torque"]:
        assert getattr(particles, name).shape == (2,)
    assert particles.role.tolist() == ["free", "free"]
    before = particles.position
    simulation.step(1000)
    assert not np.array_equal(before, particles.position)
    before[:] = 0.0
    assert particles.position.any()
    assert particles.to_pandas().shape == (2, 10)
    with pytest.raises(gouge.ArgumentError):
        simulation.column("colour")
    with pytest.raises(gouge.ArgumentError):
        simulation.interactions("beam")
    with pytest.raises(gouge.ArgumentError):
        simulation.step(-1)


def test_momentum_and_energy_are_those_of_a_collision():
    simulation = gouge.Simulation("head-on", {"contact.normal.damping": 0.0, "output.energy": True})
    mass, before = simulation.particles.mass, simulation.particles.velocity
    kinetic = simulation.energy()["kinetic"]
    assert kinetic == pytest.approx(0.5 * (mass * (before**2).sum(axis=1)).sum())
    while not simulation.contacts().rows:
        simulation.step(10)
    while simulation.contacts().rows:
        simulation.step(10)
    after = simulation.particles.velocity
    assert after == pytest.approx(-before, rel=1e-4)
    assert simulation.energy()["kinetic"] == pytest.approx(kinetic, rel=1e-4)


def test_contacts_repel_along_the_line_of_centres():
    simulation = gouge.Simulation("head-on")
    while not simulation.contacts().rows:
        simulation.step(10)
    simulation.step(100)
    contact = simulation.contacts()
    assert contact["i"].tolist() == [0] and contact["j"].tolist() == [1]
    assert contact["normal_force"][0] < 0.0 and contact["tangential_force"][0] == 0.0
    assert simulation.particles.force[0, 0] < 0.0 < simulation.particles.force[1, 0]


def test_a_checkpoint_continues_with_the_same_bits():
    simulation = gouge.Simulation("oblique")
    simulation.step(500)
    saved = simulation.checkpoint()
    simulation.step(500)
    position, energy = simulation.particles.position, simulation.energy()
    simulation.restore(saved)
    assert simulation.steps == 500
    simulation.step(500)
    assert np.array_equal(simulation.particles.position, position)
    assert simulation.energy() == energy
    other = gouge.Simulation("oblique")
    other.restore(saved)
    other.step(500)
    assert np.array_equal(other.particles.position, position)


@pytest.mark.parametrize("damage", [lambda b: b[:-3], lambda b: b"", lambda b: b + b"\0" * 8, lambda b: b[8:]])
def test_a_damaged_checkpoint_is_refused_and_changes_nothing(damage):
    simulation = gouge.Simulation("oblique")
    simulation.step(10)
    before = simulation.particles.position
    with pytest.raises(gouge.ArgumentError, match="checkpoint"):
        simulation.restore(damage(simulation.checkpoint()))
    assert np.array_equal(simulation.particles.position, before)
    with pytest.raises(gouge.ArgumentError, match="another scene"):
        simulation.restore(gouge.Simulation("head-on").checkpoint())
    flipped = bytearray(simulation.checkpoint())
    for place in range(0, len(flipped), 37):
        flipped[place] ^= 1
        with pytest.raises(gouge.ArgumentError):
            simulation.restore(bytes(flipped))
        flipped[place] ^= 1
    simulation.restore(bytes(flipped))


def test_a_fork_steps_without_the_threads_of_its_parent():
    script = """
import gouge, os
simulation = gouge.Simulation("oblique")
simulation.step(5)
child = os.fork()
simulation.step(5)
if child == 0:
    gouge.run("head-on")
    os._exit(0 if simulation.steps == 10 else 1)
assert os.waitpid(child, 0)[1] == 0
"""
    environment = os.environ | {"GOUGE_THREADS": "2"}
    subprocess.run([sys.executable, "-c", script], check=True, timeout=60, env=environment)


def test_ctrl_c_stops_between_two_steps():
    simulation = gouge.Simulation("oblique")
    threading.Timer(0.2, _thread.interrupt_main).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.step(10**12)
    assert time.monotonic() - began < 2.0
    steps = simulation.steps
    simulation.step()
    assert simulation.steps == steps + 1


def test_an_invalid_state_is_an_error():
    simulation = gouge.Simulation("head-on", {"time.step": 1e-2, "time.end": 1.0})
    with pytest.raises(gouge.StateError) as raised:
        simulation.step(10000)
    assert "time step" in str(raised.value)


def test_a_notebook_shows_the_picture():
    simulation = gouge.Simulation("oblique")
    assert simulation._repr_html_().startswith("<svg")
    assert repr(simulation) == "Simulation of 2 particles at 0 s"


def test_a_call_of_step_costs_less_than_a_microsecond():
    simulation = gouge.Simulation("head-on")
    number = 100_000

    def seconds(work):
        began = time.perf_counter()
        work()
        return time.perf_counter() - began

    def one_by_one():
        step = simulation.step
        for _ in range(number):
            step()

    pairs = [(seconds(one_by_one), seconds(lambda: simulation.step(number))) for _ in range(5)]
    overhead = min(single for single, _ in pairs) - min(together for _, together in pairs)
    assert overhead / number < 1e-6, overhead / number


def test_a_column_of_a_million_particles_is_copied_about_as_fast_as_memory_is():
    side = 1000
    scene = gouge.scene("head-on")
    scene["setup"] = {
        "seed": 1,
        "sizes": {"mean": 1e-3},
        "lattice": {"arrangement": "square", "columns": side, "rows": side, "origin": [0.0, 0.0]},
    }
    del scene["particles"], scene["contact"]
    simulation = gouge.Simulation(scene)
    assert len(simulation) == side * side
    for name in ["radius", "angle", "position", "velocity"]:
        column = simulation.column(name)
        times, copies = [], []
        for _ in range(10):
            began = time.perf_counter()
            simulation.column(name)
            read = time.perf_counter()
            column.copy()
            times.append(read - began)
            copies.append(time.perf_counter() - read)
        assert min(times) < 3 * min(copies), (name, times, copies)
