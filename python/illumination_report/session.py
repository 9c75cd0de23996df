# SPDX-License-Identifier: BSD-3-Clause
"""What a ParaView session knows of a lit surface: its filters, their settings, its pictures."""

import tempfile
from pathlib import Path

from paraview import servermanager, simple

MAP, SMOOTHING = "IlluminationMap", "IlluminationMapSmoothing"
ALWAYS = {"Method", "Registration", "Photons", "LampType", "Type", "LuminousFlux"}  # told at default, too
NOT_TOLD = {"Input", "Luminaires"}
WITHOUT_FLUX = ("Parallel", "Emitting Facets")  # lamps that have neither a flux of their own nor a place


def _inputs(proxy, name="Input"):
    """The sources that are connected to an input of a proxy."""
    if not proxy.SMProxy.GetProperty(name):
        return []
    connected = proxy.GetProperty(name)
    return [source for source in connected if source is not None]


def upstream(source, kind):
    """The nearest proxy of a kind (XML name) at or before a source; None if there is none."""
    waiting = [source]
    while waiting:
        proxy = waiting.pop(0)
        if proxy.SMProxy.GetXMLName() == kind:
            return proxy
        waiting += _inputs(proxy)
    return None


def lit_source(source=None):
    """The source to report on: the given one, the active one, or the last that has an illumination map.

    Raises RuntimeError if it does not come from an Illumination Map.
    """
    candidates = [source] if source else [simple.GetActiveSource(), *reversed(simple.GetSources().values())]
    for candidate in candidates:
        if candidate is not None and upstream(candidate, MAP):
            return candidate
    raise RuntimeError(
        "there is nothing to report on: give write_report the Illumination Map, or a filter after it"
    )


def fetched(source, port=0):
    """The data of a source's output port on the client, up to date."""
    source.UpdatePipeline()
    return servermanager.Fetch(source, idx=port)


def settings(proxy):
    """(property, value) of a filter or source as text: those that are not at their defaults."""
    told = []
    has_flux = getattr(proxy, "LampType", "") not in WITHOUT_FLUX
    for name in proxy.ListProperties():
        prop = proxy.GetProperty(name)
        if name in NOT_TOLD or not hasattr(prop, "SMProperty") or not hasattr(prop, "GetData"):
            continue  # buttons hold no value
        if name == "LuminousFlux" and not has_flux:
            continue
        if prop.SMProperty.GetPanelVisibility() == "never" or prop.SMProperty.GetInformationOnly():
            continue
        if name in ALWAYS or not prop.SMProperty.IsValueDefault():
            value = prop.GetData()
            several = isinstance(value, (list, tuple))
            told.append((name, ", ".join(map(str, value)) if several else str(value)))
    return told


def luminaires(map_proxy):
    """The proxies that are connected to Luminaires of an Illumination Map."""
    return _inputs(map_proxy, "Luminaires")


def places(map_proxy):
    """Where the lamps are that have a place, in the data's unit."""
    lamps = luminaires(map_proxy)
    if lamps:
        return [list(lamp.Position) for lamp in lamps if lamp.SMProxy.GetProperty("Position")]
    return [] if map_proxy.LampType in WITHOUT_FLUX else [list(map_proxy.LampPosition)]


def picture(view):
    """What a render view shows, as the bytes of a PNG."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "view.png"
        simple.SaveScreenshot(str(file), view, ImageResolution=list(view.ViewSize))
        return file.read_bytes()


def session_pictures():
    """Caption -> PNG of all render views of the session."""
    views = simple.GetRenderViews()
    names = {}
    for (name, _), proxy in servermanager.ProxyManager().GetProxiesInGroup("views").items():
        names[proxy.SMProxy] = name
    return {names.get(view.SMProxy, f"View {i + 1}"): picture(view) for i, view in enumerate(views)}
