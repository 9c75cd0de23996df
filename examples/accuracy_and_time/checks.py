# SPDX-License-Identifier: BSD-3-Clause
"""What is promised about accuracy and time, and whether it holds."""

import numpy as np

from runs import Run
from scenes import Truth

SEEDS = range(1, 9)
LEAST_GAIN = 20.0  # of Sobol over Random on the sphere, at SPHERE_PHOTONS
SPHERE_PHOTONS = 1_000_000
TARGET = 0.02  # on the cabin
TRUE_ERROR = (0.015, 0.02)  # where the true error may then lie
GATHERED_PHOTONS = 500_000
TRUE_OVER_TOLD = (0.8, 1.25)  # by Final Gathering
PREDICTED_AFTER = 0.1  # of the run's time
PREDICTION = 0.3  # by how much the predicted time may be off


def sobol_gain(sphere):
    """How many times Random's true error is Sobol's (RMS over SEEDS)."""
    error = {}
    for sampling in ("Random", "Sobol"):
        squares = []
        for seed in SEEDS:
            with Run(sphere, Sampling=sampling, Seed=seed) as run:
                squares.append(sphere.relative_error(run.to(SPHERE_PHOTONS)) ** 2)
        error[sampling] = np.sqrt(np.mean(squares))
    print(
        f"Sphere, {SPHERE_PHOTONS} photons: true error Random {100 * error['Random']:.4f} %,"
        f" Sobol {100 * error['Sobol']:.4f} %"
    )
    return error["Random"] / error["Sobol"]


def cabin_at_target(cabin, reference):
    """True error where the cabin's run stops by itself, and predicted over real seconds."""
    with Run(cabin, TargetRelativeError=TARGET) as run:
        lux = run.to(2_000_000_000)
        rounds = run.rounds()
    seconds = rounds["Seconds"]
    row = int(np.argmax(seconds >= PREDICTED_AFTER * seconds[-1]))
    print(
        f"Cabin, asked for {100 * TARGET:g} %: stopped after {rounds['Photons'][-1]:.0f} photons,"
        f" {seconds[-1]:.2f} s, at an estimated error of {100 * rounds['RelativeError'][-1]:.3f} %;"
        f" after {seconds[row]:.2f} s it predicted {rounds['PredictedSeconds'][row]:.2f} s"
    )
    error = cabin.relative_error(lux, reference)
    both = cabin.relative_error(lux, Truth(reference.lux))
    print(f"Cabin: true error {100 * error:.3f} %; with the long run's own {100 * both:.3f} %")
    return error, rounds["PredictedSeconds"][row] / seconds[-1]


def true_over_told(scene, truth):
    """True over told error of a scene by Final Gathering."""
    with Run(scene, Method="Final Gathering") as run:
        lux = run.to(GATHERED_PHOTONS)
        told = scene.share(run.array("StandardError"), lux)
    error = scene.relative_error(lux, truth)
    print(f"{scene.name}, Final Gathering: true error {100 * error:.2f} %, told {100 * told:.2f} %")
    return error / told


def run_checks(scenes, traced, truth):
    """Prints every check; returns how many fail.

    traced, truth: the cabin by long runs of Photon Tracing, which has the same facets as what is
    checked, and of Final Gathering.
    """
    cabin, room = scenes["cabin"], scenes["room"]
    gain = sobol_gain(scenes["sphere"])
    error, prediction = cabin_at_target(cabin, traced)
    ratios = {"room": true_over_told(room, room.exact), "cabin": true_over_told(cabin, truth)}
    low, high = TRUE_ERROR
    low_ratio, high_ratio = TRUE_OVER_TOLD
    within = f"within {100 * low:g} to {100 * high:g} %"
    results = (
        (f"Sobol's error {gain:.1f} times below Random's", gain >= LEAST_GAIN),
        (f"cabin's true error {100 * error:.3f} %, {within}", low <= error <= high),
        (f"predicted over real time {prediction:.3f}", abs(prediction - 1.0) <= PREDICTION),
    )
    results += tuple(
        (f"{name}, gathered: true over told error {ratio:.2f}", low_ratio <= ratio <= high_ratio)
        for name, ratio in ratios.items()
    )
    for text, passed in results:
        print(("passed: " if passed else "FAILED: ") + text, flush=True)
    return sum(not passed for _, passed in results)
