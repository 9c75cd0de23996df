# SPDX-License-Identifier: BSD-3-Clause
"""The refinement's proxy: defaults, documentation, what Apply does, saved states."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkSurfaceRefinement

NOT_DEFAULT = {
    "MaximumTurn": 15.0,
    "CurvatureTolerance": 0.25,
    "MaximumEdgeLength": 0.5,
    "FeatureAngle": 60.0,
    "MaximumCells": 1000,
}


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = SurfaceRefinement(Input=simple.Sphere())
    proxies.check_documented(proxy, NOT_DEFAULT)
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_defaults_of_proxy_and_class_agree():
    proxies.check_defaults(SurfaceRefinement(Input=simple.Sphere()), vtkSurfaceRefinement(), NOT_DEFAULT)


def test_it_refines_as_it_is_set_up():
    proxy = SurfaceRefinement(Input=simple.Sphere())
    proxy.UpdatePipeline()
    fine = servermanager.Fetch(proxy)
    assert fine.GetNumberOfCells() > 96 * 16
    assert fine.GetCellData().GetArray("OriginalCellIds").GetRange() == (0.0, 95.0)


def test_states_bring_everything_back():
    proxy = SurfaceRefinement(registrationName="fine", Input=simple.Sphere())
    proxies.set_all(proxy, NOT_DEFAULT)
    proxies.check_python_state("fine", NOT_DEFAULT)
    proxies.pass_through_a_state()
    proxies.check_all(simple.FindSource("fine"), NOT_DEFAULT)


if __name__ == "__main__":
    proxies.run_tests(globals())
