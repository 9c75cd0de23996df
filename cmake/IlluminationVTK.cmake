# SPDX-License-Identifier: BSD-3-Clause
# The VTK module Illumination::Illumination (library vtkIllumination) and its Python package.
include(IlluminationFindVTK)

set(illumination_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonTransforms FiltersCore FiltersGeneral
  FiltersSources IOXML IOXMLParser ParallelCore)
if (ILLUMINATION_WRAP_PYTHON)
  list(APPEND illumination_vtk_components Python WrappingPythonCore)
endif ()
if (ILLUMINATION_WITH_PARAVIEW)
  # ParaView's VTK links MPI, and its CMake files expect to be told where that is.
  find_package(MPI QUIET COMPONENTS C CXX)
  illumination_find_paraview(5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
endif ()
illumination_find_vtk(9.1 REQUIRED COMPONENTS ${illumination_vtk_components})

vtk_module_scan(
  MODULE_FILES "${PROJECT_SOURCE_DIR}/filters/Illumination/vtk.module"
  REQUEST_MODULES Illumination::Illumination
  PROVIDES_MODULES illumination_modules
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${illumination_modules}
  PACKAGE IlluminationMaps
  INSTALL_EXPORT IlluminationMaps
  HEADERS_DESTINATION "${ILLUMINATION_INCLUDE_DIR}"
  CMAKE_DESTINATION "${ILLUMINATION_CMAKE_DIR}")

if (ILLUMINATION_WRAP_PYTHON)
  vtk_module_python_default_destination(illumination_python_default)
  set(ILLUMINATION_PYTHON_DIR "${illumination_python_default}" CACHE STRING
    "Where Python modules go, relative to the prefix; a folder of Python's own search path spares its users PYTHONPATH")
  # Package and module share a name and the package shows all that the module has, so that
  # `from vtkIllumination import vtkIlluminationMap` works.
  vtk_module_wrap_python(
    MODULES ${illumination_modules}
    INSTALL_EXPORT IlluminationMapsPython
    INSTALL_HEADERS OFF
    PYTHON_PACKAGE vtkIllumination
    MODULE_DESTINATION "${ILLUMINATION_PYTHON_DIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  set(illumination_init "${CMAKE_BINARY_DIR}/${ILLUMINATION_PYTHON_DIR}/vtkIllumination/__init__.py")
  file(WRITE "${illumination_init}" "from .vtkIllumination import *\n")
  install(FILES "${illumination_init}"
    DESTINATION "${ILLUMINATION_PYTHON_DIR}/vtkIllumination")
endif ()
