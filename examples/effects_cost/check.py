# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless switches do what they should. Needs pvbatch, but no screen.

An effect that a scene doesn't call for changes no bit; of one that it calls for, the flux switched
off is that of expected.csv. check.py OUTPUT.csv writes these fluxes instead.
"""

import sys
from pathlib import Path

import numpy as np
from effects_cost import HERE, run
from furnished_room import SWITCHES, Pipeline, rooms

import tables
from illumination import load_plugin, texts

SIGMAS = 5.0
# Where lamps are kept apart, a twentieth of the photons is shared evenly, so one carries up to 20/19
# of the mean; here no lamp is so weak that its photons carry less than 19/20.
UNEVEN = 20.0 / 19.0
PHOTONS = 100_000
MORE_PHOTONS = 4_000_000  # for expected.csv
FLUX = "Flux switched off, lm"


def check_uncalled(room, pipeline):
    """All that the room does not call for is switched off: the same bits."""
    whole = run(pipeline, Photons=PHOTONS)
    called = {line.split(":")[0] for line in texts(whole.surface, "Effects") if ": on" in line}
    assert set(room.effects) - {"lamps kept apart"} <= called, (room.title, called)
    switches = {}
    for name in set(SWITCHES) - called - {"lamps kept apart"}:
        switches.update(SWITCHES[name])
    without = run(pipeline, Photons=PHOTONS, **switches)
    assert np.array_equal(whole.array(), without.array()), (room.title, switches)
    assert whole.facts["FluxSwitchedOff"] == without.facts["FluxSwitchedOff"] == 0.0, room.title


def fluxes(room, pipeline, photons):
    """What each switch takes away, as rows of expected.csv."""
    rows = []
    for name in room.effects:
        facts = run(pipeline, Photons=photons, **SWITCHES[name]).facts
        emitted, flux = facts["EmittedFlux"], facts["FluxSwitchedOff"]
        cut = emitted * facts["PhotonsCutOff"] / facts["PhotonsEmitted"]
        apart = {**room.properties, **SWITCHES[name]}.get("LampContributions", 0)
        uneven = UNEVEN if apart else 1.0
        rounding = 1e-9 * emitted
        assert cut / uneven - rounding <= flux <= cut * uneven + rounding, (room.title, name, facts)
        # Each photon is switched off once or not at all: a binomial distribution.
        share = flux / emitted
        error = emitted * np.sqrt(uneven * share * (1.0 - share) / facts["PhotonsEmitted"])
        rows.append({"Scene": room.title, "Without": name, FLUX: flux, "Error": float(error)})
    return rows


def main(file):
    """Checks; with a file, writes it instead."""
    load_plugin()
    rows = []
    for room in rooms():
        with Pipeline(room) as pipeline:
            check_uncalled(room, pipeline)
            rows += fluxes(room, pipeline, MORE_PHOTONS if file else PHOTONS)
    if file:
        tables.write_csv(rows, Path(file))
        return
    print(tables.markdown(rows))
    for row, wanted in zip(rows, tables.read(HERE / "expected.csv"), strict=True):
        assert (row["Scene"], row["Without"]) == (wanted["Scene"], wanted["Without"]), (row, wanted)
        allowed = SIGMAS * (row["Error"] + wanted["Error"])
        assert abs(row[FLUX] - wanted[FLUX]) <= allowed, (row, wanted)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
