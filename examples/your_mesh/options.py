# SPDX-License-Identifier: BSD-3-Clause
"""What can be said on the command line about a mesh, its lamp and the picture."""

import argparse
from pathlib import Path

LAMPS = {
    "parallel": "Parallel",
    "point": "Point",
    "lambertian": "Lambertian Point",
    "spot": "Spot",
    "rectangle": "Rectangle",
    "disk": "Disk",
    "facets": "Emitting Facets",
}
REGISTRATIONS = {
    "flat": "Flat",
    "facet-ratio": "Facet Ratio",
    "vertex-normalised": "Vertex Normalised",
}
METHODS = {  # of a report, with what suits them
    "photon-tracing": {"Method": "Photon Tracing"},
    "final-gathering": {"Method": "Final Gathering", "GatherRays": 1024, "AdaptiveRefinement": 1},
}
ARRAYS = {
    "total": "Illuminance",
    "direct": "IlluminanceDirect",
    "indirect": "IlluminanceIndirect",
}


def whole(text):
    """A whole number, also as 1e6."""
    return int(float(text))


def number(default, unit, text):
    """An option that takes a number."""
    return {"type": float, "default": default, "metavar": unit, "help": f"{text} ({default:g})"}


def point(text):
    """An option that takes a point or a vector."""
    return {"nargs": 3, "type": float, "metavar": ("X", "Y", "Z"), "help": text}


def name(text):
    """An option that takes the name of a cell array."""
    return {"metavar": "NAME", "help": text}


# Group -> option -> what argparse is told about it. Lengths are in the mesh's unit.
OPTIONS = {
    "lamp": {
        "--lamp": {"choices": LAMPS, "default": "parallel", "help": "what shines (parallel)"},
        "--position": point("where a lamp is, or a panel's centre"),
        "--direction": point("in which the light travels (down; parallel: from above, front, left)"),
        "--lamp-size": {
            "nargs": "+",
            "type": float,
            "metavar": "LENGTH",
            "help": "a rectangle's width and height, a disk's radius",
        },
        "--half-angle": number(30.0, "DEGREES", "a spot's, from axis to edge"),
        "--flux": number(1000.0, "LM", "of the lamp, lm"),
        "--illuminance": number(1000.0, "LX", "of parallel light on a plane across it, lx"),
        "--exitance-array": name("cell array for --lamp facets, lm/m^2"),
    },
    "surface": {
        "--reflectance": number(0.5, "SHARE", "diffuse, of all surfaces, 0 to 1"),
        "--reflectance-array": name("cell array of 1 or 3 components, 0 to 1"),
        "--metres-per-unit": number(1.0, "M", "of the mesh's lengths"),
        "--feature-angle": number(30.0, "DEGREES", "sharper edges stay where normals are missing"),
        "--reverse": {"action": "store_true", "help": "light the other side of the surface"},
    },
    "simulation": {
        "--photons": {
            "type": whole,
            "default": 4_000_000,
            "metavar": "N",
            "help": "for each registration (4e6)",
        },
        "--seed": {"type": int, "default": 1, "metavar": "N", "help": "another: independent noise (1)"},
        "--registration": {
            "choices": ["all", *REGISTRATIONS],
            "default": "all",
            "help": "one panel each (all; of a report: vertex-normalised)",
        },
    },
    "report": {
        "--report": {
            "action": "store_true",
            "help": "write one HTML page that needs no other file, in place of picture and tables: "
            "pictures, isolux plan, statistics, accuracy, what was simulated and why",
        },
        "--method": {
            "choices": METHODS,
            "default": "photon-tracing",
            "help": "of the report; final-gathering for surfaces of few large triangles, such as the walls of a "
            "room, which it refines where the light needs it (photon-tracing)",
        },
        "--parts": name("cell array of numbers or text whose parts get statistics of their own"),
        "--plan-height": {
            "type": float,
            "metavar": "LENGTH",
            "help": "of the horizontal level that the isolux plan shows (the largest)",
        },
    },
    "picture": {
        "--output": {
            "type": Path,
            "metavar": "PATH",
            "help": "the picture, with tables beside it, or the report (examples/output/your_mesh/FILE.png, .html)",
        },
        "--show": {"choices": ARRAYS, "default": "total", "help": "which illuminance (total)"},
        "--range": {
            "nargs": 2,
            "type": float,
            "metavar": ("FROM", "TO"),
            "help": "of the colours, lx (from 0 to what 98 %% of the area stay below)",
        },
        "--lines": number(0.0, "LX", "draw a line every so many lx; 0: none"),
        "--up": {"choices": "xyz", "default": "z", "help": "the axis that points up (z)"},
        "--camera": point("where the camera stands (in front, above, with all in view)"),
        "--focus": point("what it looks at (the middle)"),
        "--view-angle": number(30.0, "DEGREES", "of the camera, from bottom to top"),
        "--size": {
            "nargs": 2,
            "type": int,
            "default": (2000, 620),
            "metavar": ("WIDTH", "HEIGHT"),
            "help": "width of all and height of a panel, pixels (2000 620)",
        },
        "--save": {
            "type": Path,
            "metavar": "FILE",
            "help": "write the surface with the last registration's arrays, such as lit.vtp",
        },
    },
}


def new_parser():
    """The parser of all options."""
    parser = argparse.ArgumentParser(
        prog="examples/run",
        description="Lights a mesh of yours, in any format that ParaView reads, "
        "and draws how many lux arrive where.",
    )
    help_text = "the mesh; the side that its normals point to is lit"
    parser.add_argument("file", type=Path, metavar="FILE", help=help_text)
    for title, options in OPTIONS.items():
        group = parser.add_argument_group(title)
        for option, description in options.items():
            short = ["-o"] if option == "--output" else []
            group.add_argument(*short, option, **description)
    return parser


def read_options(arguments=None):
    """The options; leaves with a message where they do not fit together."""
    parser = new_parser()
    options = parser.parse_args(arguments)
    if options.lamp not in ("parallel", "facets") and options.position is None:
        parser.error(f"--lamp {options.lamp} needs --position X Y Z")
    wanted = {"rectangle": 2, "disk": 1}.get(options.lamp, 0)
    if wanted and len(options.lamp_size or ()) != wanted:
        parser.error(f"--lamp {options.lamp} needs --lamp-size with {wanted} length(s)")
    if options.lamp == "facets" and not options.exitance_array:
        parser.error("--lamp facets needs --exitance-array NAME")
    if options.range and not options.range[0] < options.range[1]:
        parser.error("--range needs FROM below TO")
    if not options.report and (options.parts or options.plan_height is not None):
        parser.error("--parts and --plan-height are for --report")
    if not options.file.exists():
        parser.error(f"there is no file {options.file}")
    return options
