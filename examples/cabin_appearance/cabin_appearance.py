# SPDX-License-Identifier: BSD-3-Clause
"""The aircraft cabin as it looks: the paper's figures 7 to 9 as the paper draws them.

Run by pvbatch: cabin_appearance.py OUTPUT_DIR. Writes cabin_appearance.png there.
"""

import sys
from pathlib import Path

from paraview import simple
from PIL import Image

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common"), str(HERE.parent / "cabin")]

from cabin_geometry import make_cabin  # noqa: E402
from illumination import as_source, load_plugin  # noqa: E402
from pictures import GAP, MARGIN, TITLE, Camera, Page, captured, new_view  # noqa: E402

PHOTONS = 2_000_000
WIDTH = 1400  # pixels
ALONG_THE_AISLE = Camera(position=(0.12, 0.0, 1.5), focus=(4.0, 0.0, 1.37), angle=62.0)
BIN_AND_SEATS = Camera(position=(1.0, -0.1, 1.62), focus=(2.7, 0.95, 1.42), angle=40.0)
TITLES = {
    "Flat": "Flat (the paper's Fig. 7)",
    "Facet Ratio": "Facet Ratio (Fig. 8)",
    "Vertex Normalised": "Vertex Normalised, smoothed (Fig. 9)",
}
CABIN = {"LampType": "Emitting Facets", "ExitanceArray": "Exitance", "ReflectanceArray": "Reflectance"}
EXPOSURE = {"AdaptationLuminance": 22.0}  # cd/m^2, the same for all pictures


def lit(source, registration):
    """The filters that light the cabin; the last registration's map is smoothed."""
    found = simple.IlluminationMap(Input=source, Registration=registration, Photons=PHOTONS, **CABIN)
    return simple.IlluminationMapSmoothing(Input=found) if registration == "Vertex Normalised" else found


def picture(look, camera, pixels):
    """What a camera sees: (height, width, 3), 0 to 1."""
    view = new_view(camera, pixels, (0.0, 0.0, 0.0))
    return captured(view, [simple.Show(look, view)])


def main(output):
    """Lights the cabin three times and draws it from two places."""
    load_plugin()
    source = as_source(make_cabin())
    column = (WIDTH - 2 * MARGIN - 2 * GAP) // 3
    heights = (300, 300)
    large = (WIDTH - 2 * MARGIN, 780)
    page = Page(WIDTH, 2 * MARGIN + 2 * TITLE + sum(heights) + large[1] + 3 * GAP)
    for i, (registration, title) in enumerate(TITLES.items()):
        look = simple.IlluminatedAppearance(Input=lit(source, registration), **EXPOSURE)
        left, top = MARGIN + i * (column + GAP), MARGIN
        page.write(left, top, title, fontsize=13, fontweight="bold")
        top += TITLE
        for camera, height in zip((ALONG_THE_AISLE, BIN_AND_SEATS), heights):
            image = picture(look, camera, (column, height))
            page.place(left, top, column, height).imshow(image, interpolation="none", aspect="auto")
            top += height + GAP
    page.write(MARGIN, top, "The last map, large", fontsize=13, fontweight="bold")
    image = picture(look, ALONG_THE_AISLE, large)
    page.place(MARGIN, top + TITLE, *large).imshow(image, interpolation="none", aspect="auto")
    path = output / "cabin_appearance.png"
    page.save(path)
    Image.open(path).convert("L").convert("P").save(path, optimize=True)  # all of it is grey


if __name__ == "__main__":
    main(Path(sys.argv[1]))
