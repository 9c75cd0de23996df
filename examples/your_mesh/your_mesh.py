# SPDX-License-Identifier: BSD-3-Clause
"""The illumination map of a mesh of yours, by every registration. Run by ../run FILE [options]."""

import sys
import tempfile
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from illumination import IlluminationMap, as_source, facts_of, illuminate, load_plugin, python_packages, texts  # noqa: E402
from options import ARRAYS, LAMPS, METHODS, REGISTRATIONS, read_options  # noqa: E402
from pictures import BAR, GAP, MARGIN, Panel, Row, Scale, appearance, draw  # noqa: E402
from viewpoint import camera_for, down, light_direction  # noqa: E402

GREY = (0.42, 0.44, 0.47)


def read_surface(options):
    """The file's surfaces as one vtkPolyData."""
    reader = simple.OpenDataFile(str(options.file))
    reader.UpdatePipeline()
    kind = reader.GetDataInformation().GetDataSetTypeAsString()
    if kind != "vtkPolyData":
        reader = simple.ExtractSurface(Input=reader)
        kept = {"OutputDataSetType": "Polygonal Mesh", "MergePoints": 0}  # edges stay sharp
        reader = simple.MergeBlocks(Input=reader, **kept)
    if options.reverse:
        reader = simple.ReverseSense(Input=reader)
    reader.UpdatePipeline()
    surface = servermanager.Fetch(reader)
    if not surface or surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        sys.exit(f"{options.file} holds no surface that could be lit (read as {kind})")
    return surface


def filter_properties(options):
    """The options as properties of the filter."""
    parallel = options.lamp == "parallel"
    default = light_direction(options.up) if parallel else down(options.up)
    properties = {
        "LampType": LAMPS[options.lamp],
        "LampDirection": list(options.direction or default),
        "SpotHalfAngle": options.half_angle,
        "LuminousFlux": options.flux,
        "ParallelIlluminance": options.illuminance,
        "Reflectance": options.reflectance,
        "MetresPerUnit": options.metres_per_unit,
        "FeatureAngle": options.feature_angle,
        "Photons": options.photons,
        "Seed": options.seed,
    }
    optional = {
        "LampPosition": options.position,
        "LampSize": options.lamp_size and (options.lamp_size * 2)[:2],
        "ReflectanceArray": options.reflectance_array,
        "ExitanceArray": options.exitance_array,
    }
    properties.update({key: value for key, value in optional.items() if value is not None})
    return properties


def triangle_values(surface, values):
    """Area (data's unit, squared) and mean of a point array for every triangle of a vtkPolyData."""
    triangles = simple.Triangulate(Input=as_source(surface))
    triangles.UpdatePipeline()
    corners = servermanager.Fetch(triangles).GetPolys().GetConnectivityArray()
    corners = vtk_to_numpy(corners).reshape(-1, 3)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    a, b, c = points[corners].transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1), values[corners].mean(axis=1)


def quantiles(area, values, shares):
    """What values the given shares of the area stay below."""
    order = np.argsort(values)
    return np.interp(shares, np.cumsum(area[order]) / area.sum(), values[order])


def row_of(name, found, array):
    """One row of the table: illuminance over the area, photons and time."""
    area, lux = triangle_values(found.surface, found.array(array))
    noise = found.array("StandardError")
    area_and_noise = triangle_values(found.surface, noise**2)
    mean = float(np.average(lux, weights=area))
    middle, high = (float(v) for v in quantiles(area, lux, [0.5, 0.95]))
    facts = found.facts
    return {
        "Registration": name,
        "Mean, lx": mean,
        "Median, lx": middle,
        "95 %, lx": high,
        "Noise of the total, lx": float(np.sqrt(np.average(area_and_noise[1], weights=area))),
        **{key: int(facts[f"Photons{key}"]) for key in ("Emitted", "Absorbed", "Escaped")},
        "Seconds": facts["Seconds"],
        "Million segments/s": facts["SegmentsPerSecond"] / 1e6,
    }


def draw_maps(options, maps, path):
    """The maps (registration -> IlluminationMap) side by side."""
    array = ARRAYS[options.show]
    points = vtk_to_numpy(next(iter(maps.values())).surface.GetPoints().GetData()).astype(float)
    width, height = options.size
    panel = (width - 2 * MARGIN - BAR) // len(maps) - GAP
    view = (options.up, options.view_angle, panel / height, options.camera, options.focus)
    tops = [quantiles(*triangle_values(m.surface, m.array(array)), 0.98) for m in maps.values()]
    lowest, highest = options.range or (0.0, float(max(tops)) or 1.0)
    clips = max(m.array(array).max() for m in maps.values()) > highest
    scale = Scale(f"{array}, lx", lowest, highest, line_every=options.lines, clips=clips)
    culled = options.report  # of a room one sees the inside, as Illuminated Appearance shows it
    panels = [Panel(name, found.surface, array, culled=culled) for name, found in maps.items()]
    rows = [Row(scale, panels, camera_for(points, *view), height)]
    draw(path, rows, width, f"{options.file.name}, {LAMPS[options.lamp]} lamp", GREY)


def save(surface, file):
    """Writes a vtkPolyData to a file, in the format that the file's ending names."""
    try:
        writer = simple.CreateWriter(str(file), as_source(surface))
    except AttributeError:  # how ParaView 5.11 says that it has none
        raise RuntimeError(f"ParaView writes no surface to a file such as {file}") from None
    file.parent.mkdir(parents=True, exist_ok=True)
    file.touch()  # the writer itself does not say where it cannot write
    writer.UpdatePipeline()
    print(f"Surface: {file}")


def report_on(options, surface, properties):
    """Lights a surface once and writes the report. Returns the IlluminationMap."""
    sys.path[:0] = python_packages()
    from illumination_report import write_report

    registration = "Vertex Normalised" if options.registration == "all" else REGISTRATIONS[options.registration]
    lit = simple.IlluminationMap(
        Input=as_source(surface), Registration=registration, **METHODS[options.method], **properties)  # fmt: skip
    # Points where the map was refined differ too much from their neighbours to be smoothed.
    shown = lit if options.method == "final-gathering" else simple.IlluminationMapSmoothing(Input=lit)
    look = simple.IlluminatedAppearance(Input=shown)
    look.UpdatePipeline()
    found = servermanager.Fetch(look)
    if not found.GetPointData().HasArray("DisplayColours"):
        raise RuntimeError("there is nothing to report on; the message is above")
    found = IlluminationMap(found, facts_of(found))
    path = options.output or HERE.parent / "output" / "your_mesh" / f"{options.file.stem}.html"
    points = vtk_to_numpy(found.surface.GetPoints().GetData()).astype(float)
    width, height = options.size[0] // 2, options.size[1]
    view = (options.up, options.view_angle, width / height, options.camera, options.focus)
    with tempfile.TemporaryDirectory() as folder:
        pictures = {"As it looks": Path(folder) / "look.png", "Illuminance": Path(folder) / "map.png"}
        appearance(pictures["As it looks"], look, camera_for(points, *view), (width, height))
        options.size = (width, height)
        draw_maps(options, {METHODS[options.method]["Method"]: found}, pictures["Illuminance"])
        more = {"parts": options.parts, "up": options.up, "plan_height": options.plan_height}
        write_report(path, look, title=f"Illumination of {options.file.name}", pictures=pictures, **more)
    print(f"Report: {path}")
    return found


def main():
    """Reads, lights, draws and tabulates, or writes a report."""
    options = read_options()
    load_plugin()
    surface = read_surface(options)
    properties = filter_properties(options)
    if options.report:
        found = report_on(options, surface, properties)
        if options.save:
            save(found.surface, options.save)
        return
    wanted = [options.registration] if options.registration != "all" else REGISTRATIONS
    names = [REGISTRATIONS[key] for key in wanted]
    maps = {name: illuminate(surface, Registration=name, **properties) for name in names}
    path = options.output or HERE.parent / "output" / "your_mesh" / f"{options.file.stem}.png"
    array = ARRAYS[options.show]
    rows = [row_of(name, found, array) for name, found in maps.items()]
    for note in texts(maps[names[-1]].surface, "Notes"):
        print(f"Note: {note}")
    tables.write(rows, path.with_suffix(""), f"{options.file.name}: {array}")
    draw_maps(options, maps, path)
    if options.save:
        save(maps[names[-1]].surface, options.save)


if __name__ == "__main__":
    try:
        main()
    except (RuntimeError, OSError) as error:  # those tell the user what is wrong
        sys.exit(f"examples/run: {error}")
