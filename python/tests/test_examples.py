"""The programs of python/examples, smaller where they take long."""

import sys
from importlib import import_module
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))

SHORT = {
    "setup.relax.0.duration": 1e-5,
    "setup.press.0.duration": 1e-5,
    "time.end": 1e-4,
    "output.interval": 5e-5,
}


def example(name, *needed):
    for package in [*needed, "matplotlib"]:
        pytest.importorskip(package)
    return import_module(name)


def test_emcee_finds_the_damping_of_the_measured_rebound():
    program = example("rebound_emcee", "emcee")
    dampings = program.sample(steps=100)
    restitutions = [program.restitution(damping) for damping in dampings[::20]]
    # The damping is bounded below, which cuts off the strongest rebounds.
    assert sum(restitutions) / len(restitutions) == pytest.approx(program.MEASURED, abs=program.ERROR)


def test_grainlearning_recovers_stiffness_and_damping():
    program = example("rebound_grainlearning", "grainlearning")
    assert program.most_probable(program.calibrate()) == pytest.approx(program.TRUTH, rel=0.15)


def test_ovito_opens_a_run(tmp_path):
    program = example("view_ovito", "ovito")
    pipeline = program.opened(tmp_path, SHORT)
    last = pipeline.compute(pipeline.num_frames - 1)
    assert pipeline.num_frames == 3 and last.particles.count == 170
    assert last.particles["Radius"][...].min() > 0.0


def test_pyvista_opens_a_run(tmp_path):
    program = example("view_pyvista", "pyvista")
    spheres = program.spheres(tmp_path, SHORT)
    low, high = spheres.bounds[0], spheres.bounds[1]
    # The block is 25 mm wide, and its outermost grains reach beyond it.
    assert 0.025 < high - low < 0.03
