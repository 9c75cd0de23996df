# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window as a user has it, for scripts that paraview --script=... runs in it."""
import ctypes
import os

# PyDLL keeps the interpreter locked, which ParaView relies on when its events call Python.
_helper = ctypes.PyDLL(os.environ["ILLUMINATION_WINDOW_HELPER"])
_helper.window_labels.restype = ctypes.c_char_p


def wait(seconds=0.1):
    _helper.window_wait(int(1000 * seconds))


def resize(width, height, panel=None):
    """@param panel Width of the properties panel."""
    _helper.window_resize(width, height)
    wait()
    if panel:
        _helper.window_panel_width(panel)
    wait()


def _done(function, name, seconds):
    result = function(name.encode())
    assert result == 1, f"{name} is {'disabled' if result else 'not there'}"
    wait(seconds)


def trigger(action, seconds=0.1):
    """An action of a menu or tool bar, such as IlluminationMap of the menu Filters."""
    _done(_helper.window_trigger, action, seconds)


def click(button, seconds=0.1):
    _done(_helper.window_click, button, seconds)


def apply(seconds=0.2):
    click("Accept", seconds)


def apply_if_offered(seconds=0.2):
    if offers("Accept"):
        apply(seconds)


def enter(field, text, number=0):
    """Types into a property's field of the properties panel; of several, into that of this number."""
    assert _helper.window_enter(field.encode(), number, text.encode()) == 1, field
    wait()


def has_icon(action):
    return bool(_helper.window_has_icon(action.encode()))


def labels():
    """The texts of the properties panel's labels."""
    return _helper.window_labels().decode().splitlines()


def offers(widget):
    """Whether the properties panel has a widget of this name that is visible and enabled."""
    return bool(_helper.window_offers(widget.encode()))


def picture(file):
    """Saves the whole screen."""
    wait()
    assert _helper.window_picture(file.encode()), file


def close():
    _helper.window_close()
