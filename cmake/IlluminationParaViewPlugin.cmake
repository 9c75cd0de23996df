# SPDX-License-Identifier: BSD-3-Clause
# The plugin IlluminationMaps, in the folder below the library folder where ParaView keeps its own.

# Help pages in ParaView's help window come from Qt's tools; without them the same text still
# shows as tooltips and in Python's help().
if (PARAVIEW_USE_QT)
  if (NOT PARAVIEW_QT_MAJOR_VERSION)
    set(PARAVIEW_QT_MAJOR_VERSION 5) # ParaView before 5.13 does not say
  endif ()
  find_package(Qt${PARAVIEW_QT_MAJOR_VERSION} QUIET COMPONENTS Help)
  find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns)
endif ()
if (Qt${PARAVIEW_QT_MAJOR_VERSION}Help_FOUND AND qt_xmlpatterns_executable)
  set(illumination_no_help_pages OFF)
else ()
  message(STATUS "No help pages in the plugin: they need Qt Help and xmlpatterns.")
  set(illumination_no_help_pages ON)
endif ()

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/plugin/paraview.plugin"
  PROVIDES_PLUGINS illumination_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${illumination_plugins}
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME illumination.plugins.xml
  DISABLE_XML_DOCUMENTATION ${illumination_no_help_pages})

# ParaView looks for plugins that it was not built with only where it is told to.
install(CODE "message(STATUS \"ParaView loads the plugin at start with PV_PLUGIN_PATH=\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/IlluminationMaps\")")
