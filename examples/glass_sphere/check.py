# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the caustic is that of a smooth glass sphere, but for what the facets do to it.

A facet's normal is off the sphere's by up to the angle from its middle to a corner, to all sides
alike. That blurs the caustic, by a width that halves with the facets. A mean over much more than
that width changes by its square, over as much by about the width itself: no ring of the floor is
much narrower. So facets half as long must be at most half as far off, but for noise. Needs pvbatch,
but no screen.
"""

import sys

import numpy as np
from glass_sphere import COARSE, FINE, GLASS, ILLUMINANCE, RINGS, caustic, mean_and_error

from exact_caustic import ring_fluxes
from illumination import load_plugin

SIGMAS = 5.0
SIGMAS_TOTAL = 3.0
SINGLE = 2.0**-23  # relative precision of the numbers that illuminance is stored as


def check_balance(found):
    """Every photon is accounted for. Glass absorbs none: those absorbed are the floor's flux."""
    for facts, flux in zip(found.facts, found.fluxes().sum(axis=1)):
        emitted, absorbed = facts["PhotonsEmitted"], facts["PhotonsAbsorbed"]
        assert emitted == absorbed + facts["PhotonsEscaped"] + facts["PhotonsCutOff"], facts
        assert facts["FluxSwitchedOff"] == 0.0 and facts["FluxCutByWeightBound"] == 0.0, facts
        absorbed_flux = facts["EmittedFlux"] * absorbed / emitted
        assert abs(flux / absorbed_flux - 1.0) <= SINGLE, (flux, absorbed_flux)


def check_total(found, exact):
    """All the floor's flux, to which it matters little where on the floor light lands.

    Light that enters next to the sphere's edge can be caught between facets, reflected totally
    again and again, until it is cut off; there must be less of it than can be noticed.
    """
    mean, error = mean_and_error(found.fluxes().sum(axis=1))
    flux, emitted, lost = (
        sum(facts[name] for facts in found.facts)
        for name in ("EmittedFlux", "PhotonsEmitted", "PhotonsCutOff")
    )
    lost *= flux / len(found.facts) / emitted
    print(f"{lost:.5f} lm caught in the glass; standard error of the floor's flux {error:.5f} lm")
    assert lost <= error
    off = (mean - exact.sum()) / error
    print(f"floor's flux {mean:.4f} lm, exact {exact.sum():.4f} lm: {off:.1f} standard errors off")
    assert abs(off) <= SIGMAS_TOTAL


def check_encircled(coarse, fine, exact):
    """Flux within each distance from the axis."""
    of_coarse, error_of_coarse = mean_and_error(coarse.encircled())
    of_fine, error = mean_and_error(fine.encircled())
    wanted = np.cumsum(exact)
    facets = 0.5 * np.abs(of_coarse - wanted)
    noise = np.hypot(error, 0.5 * error_of_coarse)
    beyond = (np.abs(of_fine - wanted) - facets) / noise
    worst = beyond.argmax()
    where = f"{1000.0 * RINGS.radii[worst]:.1f} mm"
    print(f"flux within {where}, the worst: {beyond[worst]:.1f} standard errors beyond the facets'")
    assert beyond[worst] <= SIGMAS


def misplaced(found, exact):
    """Flux that rings have too much or too little, in lm, and how much of it noise would give."""
    mean, error = mean_and_error(found.fluxes())
    return np.abs(mean - exact).sum(), np.sqrt(2.0 / np.pi) * error.sum()


def check_rings(coarse, fine, exact):
    """The rings' own flux, taken together: where light is faint, a ring is lit by few facets."""
    of_coarse, _ = misplaced(coarse, exact)
    of_fine, noise = misplaced(fine, exact)
    print(f"in wrong rings {of_coarse:.3f} lm, then {of_fine:.3f} lm, of it noise {noise:.3f} lm")
    assert of_fine - noise <= 0.5 * of_coarse


if __name__ == "__main__":
    load_plugin()
    smooth = ring_fluxes(GLASS, RINGS, ILLUMINANCE)
    by_size = [caustic(size) for size in (COARSE, FINE)]
    for one in by_size:
        check_balance(one)
    check_total(by_size[1], smooth)
    check_encircled(*by_size, smooth)
    check_rings(*by_size, smooth)
