# SPDX-License-Identifier: BSD-3-Clause
"""The table of statistics, as Illuminance Statistics tells them."""

from vtkIllumination import vtkIlluminanceStatistics
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController

COLUMNS = {  # of vtkIlluminanceStatistics -> of the report
    "Area": "Area, m²",
    "Mean": "Mean, lx",
    "Minimum": "Minimum, lx",
    "Maximum": "Maximum, lx",
    "U0": "U0 (min/mean)",
    "Ud": "Ud (min/max)",
    "Flux": "Flux, lm",
}


def _run(statistics):
    """Updates a filter that has the whole data. Under MPI it would wait for those of other ranks."""
    ranks = vtkMultiProcessController.GetGlobalController()
    vtkMultiProcessController.SetGlobalController(vtkDummyController())
    try:
        statistics.Update()
    finally:
        vtkMultiProcessController.SetGlobalController(ranks)


class Statistics:
    """Rows of the table, and what is to be said of its errors.

    rows: (name, {column: (value, standard error or None)}). notes: lines of text.
    """

    def __init__(self, array, metres_per_unit=1.0):
        """array: point array, lx, such as Illuminance."""
        self.array, self.metres_per_unit = array, metres_per_unit
        self.rows, self.notes = [], []

    def add(self, surfaces, name=None, parts=None, part_names=()):
        """Adds a row for some LitTriangles together, or for each of their parts.

        parts: name of a cell array. part_names: of its values 0, 1 and so on. Raises RuntimeError where
        the filter has failed.
        """
        table = self._table(surfaces, parts)
        for row in range(table.GetNumberOfRows()):
            value = table.GetValueByName(row, "Name").ToString()
            known = value.isdecimal() and int(value) < len(part_names)
            part = part_names[int(value)] if known else value if parts else ""
            self.rows.append((name or part, self._values(table, row)))

    def _table(self, surfaces, parts):
        together = vtkAppendPolyData()
        for surface in surfaces:
            together.AddInputData(surface.mesh)
        statistics = vtkIlluminanceStatistics()
        statistics.SetInputConnection(together.GetOutputPort())
        statistics.SetIlluminanceArray(self.array)
        statistics.SetStandardErrorArray(self.array.replace("Illuminance", "StandardError"))
        statistics.SetPartArray(parts or "")
        statistics.SetMetresPerUnit(self.metres_per_unit)
        _run(statistics)
        table = statistics.GetOutput()
        if table.GetNumberOfRows() == 0:
            raise RuntimeError("Illuminance Statistics has failed; its message is above")
        notes = table.GetFieldData().GetAbstractArray("Notes")
        for note in (notes.GetValue(i) for i in range(notes.GetNumberOfValues())):
            self.notes += [note] if note not in self.notes else []
        return table

    @staticmethod
    def _values(table, row):
        def number(name):
            return table.GetValueByName(row, name).ToDouble() if table.GetColumnByName(name) else None

        return {heading: (number(name), number(f"{name}Error")) for name, heading in COLUMNS.items()}
