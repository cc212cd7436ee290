"""GrainLearning recovers the stiffness and the damping of a contact from the kinetic energy during a collision.

The measurement is made up: a collision with a stiffness of 1e7 kg/s^2 and a damping of 5 kg/s.
"""

import gouge
import matplotlib.pyplot as plt
import numpy as np
from grainlearning import BayesianCalibration
from grainlearning.dynamic_systems import DynamicSystem

TRUTH = np.array([1e7, 5.0])
SCENE = {"time.end": 1.2e-5, "output.interval": 2e-7}


def collision(stiffness, damping):
    """Times in s, and the kinetic energy of two colliding grains in units of the first one."""
    overrides = {"contact.normal.stiffness": stiffness, "contact.normal.damping": damping}
    series = gouge.run("head-on", overrides=SCENE | overrides).series
    return series["time"], series["kinetic"] / series["kinetic"][0]


def simulate(calibration):
    """Collisions for all samples of an iteration; GrainLearning calls this."""
    energies = [collision(*10.0**sample)[1] for sample in calibration.system.param_data]
    calibration.system.set_sim_data(np.array(energies)[:, np.newaxis, :])


def calibrate(samples=20, iterations=6):
    """The calibration; its parameters are logarithms to the base 10."""
    time, energy = collision(*TRUTH)
    calibration = BayesianCalibration.from_dict(
        {
            "num_iter": iterations,
            "callback": simulate,
            "system": {
                "system_type": DynamicSystem,
                "model_name": "rebound",
                "param_names": ["log10 stiffness", "log10 damping"],
                "param_min": [6.0, 0.0],
                "param_max": [8.0, 1.5],
                "num_samples": samples,
                "obs_names": ["kinetic energy"],
                "obs_data": energy,
                "ctrl_name": "time",
                "ctrl_data": time,
                "sim_name": "rebound",
            },
            "inference": {
                "Bayes_filter": {"ess_target": 0.3},
                "sampling": {"max_num_components": 1, "seed": 0},
            },
            "save_fig": -1,
        }
    )
    calibration.run()
    return calibration


def most_probable(calibration):
    """Stiffness in kg/s^2 and damping in kg/s of the most probable sample."""
    return 10.0 ** np.array(calibration.get_most_prob_params())


if __name__ == "__main__":
    best = most_probable(calibrate())
    print(f"stiffness {best[0]:.3g} kg/s^2 (truth 1e7), damping {best[1]:.3g} kg/s (truth 5)")
    for parameters, style, label in [(TRUTH, "k-", "measured"), (best, "C1--", "calibrated")]:
        time, energy = collision(*parameters)
        plt.plot(1e6 * time, energy, style, label=label)
    plt.xlabel("time in microseconds")
    plt.ylabel("kinetic energy over its first value")
    plt.legend()
    plt.savefig("rebound_grainlearning.svg")
