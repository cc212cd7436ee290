"""Which damping lets grains of granite rebound with 0.83 +/- 0.06 of their speed (Durda et al. 2011)?

The posterior of the damping is sampled with emcee. Every step of a walker is a collision.
"""

import emcee
import gouge
import matplotlib.pyplot as plt
import numpy as np

MEASURED, ERROR = 0.83, 0.06
RANGE = np.log([0.05, 20.0])
"""Logarithms of the least and the largest damping in kg/s; in between, all are equally likely beforehand."""


def restitution(damping):
    """The part of their speed that two grains keep."""
    overrides = {"contact.normal.damping": damping, "time.end": 12e-6}
    simulation = gouge.Simulation("head-on", overrides)
    before = simulation.energy()["kinetic"]
    simulation.step(round(simulation.end / simulation.time_step))
    return np.sqrt(simulation.energy()["kinetic"] / before)


def log_posterior(parameters):
    """The logarithm of the posterior of the logarithm of the damping, up to a constant."""
    if not RANGE[0] < parameters[0] < RANGE[1]:
        return -np.inf
    return -0.5 * ((restitution(np.exp(parameters[0])) - MEASURED) / ERROR) ** 2


def sample(steps=400, walkers=8, seed=1):
    """Dampings in kg/s, sampled from the posterior."""
    np.random.seed(seed)
    sampler = emcee.EnsembleSampler(walkers, 1, log_posterior)
    start = np.random.uniform(*RANGE, size=(walkers, 1))
    sampler.run_mcmc(start, steps)
    return np.exp(sampler.get_chain(discard=steps // 4, flat=True)[:, 0])


if __name__ == "__main__":
    dampings = sample()
    low, high = np.quantile(dampings, [0.05, 0.95])
    print(f"damping: 90 % of the posterior is from {low:.2f} to {high:.2f} kg/s")
    plt.hist(np.log10(dampings), bins=40, density=True)
    plt.xlabel("log10 of the damping in kg/s")
    plt.ylabel("density")
    plt.savefig("rebound_emcee.svg")
