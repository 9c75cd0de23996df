# SPDX-License-Identifier: BSD-3-Clause
"""An example's figure looks as it did: it is drawn again and compared with the committed one.

Usage: TestFigures.py NAME, for examples/NAME/NAME.py and .png.

Fonts and anti-aliasing differ between versions, so both are reduced to cells of 16 x 16 pixels
first. What remains of a change of version is below MOST_DIFFERENT; a lamp moved by a few degrees,
another colour scale or a black patch are far above it.
"""

import runpy
import sys
import tempfile
from pathlib import Path

import numpy as np
from matplotlib import image

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CELL = 16  # pixels
MOST_DIFFERENT = 0.02  # root mean square over cells and channels, of the full range


def cells(file_name):
    """The picture's mean colours by cell, in [0, 1]: rows x columns x 3."""
    pixels = image.imread(file_name)[..., :3]
    rows, columns = (size // CELL for size in pixels.shape[:2])
    pixels = pixels[: rows * CELL, : columns * CELL]
    return pixels.reshape(rows, CELL, columns, CELL, 3).mean(axis=(1, 3))


def main():
    """Draws, compares, fails if they differ."""
    name = sys.argv[1]
    script = EXAMPLES / name / f"{name}.py"
    folder = tempfile.mkdtemp()
    sys.argv = [str(script), folder]
    sys.path.insert(0, str(script.parent))
    runpy.run_path(str(script), run_name="__main__")
    drawn, baseline = cells(Path(folder) / f"{name}.png"), cells(script.with_suffix(".png"))
    assert drawn.shape == baseline.shape, (drawn.shape, baseline.shape)
    difference = np.sqrt(np.mean((drawn - baseline) ** 2))
    print(f"{name}: differs by {difference:.4f}, at most {MOST_DIFFERENT} is allowed")
    assert difference <= MOST_DIFFERENT


if __name__ == "__main__":
    main()
