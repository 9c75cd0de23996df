# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of ParaView's proxies share.

A test names the properties of its proxy with values that are not the default, {name: value}. Where the
class has another value than ParaView shows, the value is a pair (in ParaView, of the class); vectors are
lists.
"""
import os
import tempfile

from paraview import simple, smstate


def in_paraview(value):
    return value[0] if isinstance(value, tuple) else value


def of_class(value):
    if isinstance(value, tuple):
        return value[1]
    return tuple(value) if isinstance(value, list) else value


def get(proxy, name):
    """The class's value of a property."""
    return getattr(proxy.GetClientSideObject(), "Get" + name)()


def set_all(proxy, properties):
    for name, value in properties.items():
        setattr(proxy, name, in_paraview(value))
    proxy.UpdateVTKObjects()


def check_all(proxy, properties):
    for name, value in properties.items():
        assert get(proxy, name) == of_class(value), (name, get(proxy, name))


def check_documented(proxy, names):
    """These are the proxy's properties but its inputs, and each has a help text."""
    assert sorted(names) == sorted(set(proxy.ListProperties()) - {"Input", "Luminaires", "Sensors"})
    for name in names:
        assert len(proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()) > 40, name


def check_reach(proxy, properties):
    """Properties that have their defaults reach the class once they are set."""
    for name, value in properties.items():
        assert get(proxy, name) != of_class(value), name
    set_all(proxy, properties)
    check_all(proxy, properties)


def check_defaults(proxy, of_its_own, names):
    """Proxy and class have the same defaults."""
    proxy.UpdateVTKObjects()
    for name in names:
        by_proxy, by_class = get(proxy, name), getattr(of_its_own, "Get" + name)()
        # An array list has to name its empty choice; the class has no array by default.
        assert by_proxy == by_class or (by_proxy, by_class or "") == ("None", ""), (name, by_proxy, by_class)


def pass_through_a_state():
    """Saves a state, begins a new session and loads it there."""
    with tempfile.TemporaryDirectory() as folder:
        state = os.path.join(folder, "state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)


def check_python_state(name, properties):
    """The Python state sets these properties of the source of this name."""
    script = smstate.get_state()
    for key, value in properties.items():
        assert f"{name}.{key} = {in_paraview(value)!r}" in script, (key, script)


def run_tests(names):
    """Calls all functions whose name begins with test_, each in a session with the plugin."""
    for name, test in list(names.items()):
        if name.startswith("test_"):
            print(name, flush=True)
            simple.ResetSession()
            simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=names)
            test()
