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

# The part for ParaView's window needs its client libraries. What those link to in turn (HDF5, NetCDF,
# GLEW and more) is of no use here, and would ask for the -dev packages of all of it.
set(illumination_with_panel OFF)
if (PARAVIEW_USE_QT AND TARGET ParaView::pqApplicationComponents)
  find_package(Qt${PARAVIEW_QT_MAJOR_VERSION} QUIET COMPONENTS Core Gui Widgets)
endif ()
if (Qt${PARAVIEW_QT_MAJOR_VERSION}Widgets_FOUND)
  set(illumination_with_panel ON)
  set(illumination_client_links ParaView::RemotingCore Qt${PARAVIEW_QT_MAJOR_VERSION}::Widgets
    "$<TARGET_FILE:ParaView::RemotingServerManager>")
  foreach (library IN ITEMS pqCore pqComponents pqApplicationComponents)
    get_target_property(configurations "ParaView::${library}" IMPORTED_CONFIGURATIONS)
    foreach (configuration IN LISTS configurations)
      set_property(TARGET "ParaView::${library}" PROPERTY
        "IMPORTED_LINK_DEPENDENT_LIBRARIES_${configuration}")
    endforeach ()
    set_property(TARGET "ParaView::${library}" PROPERTY
      INTERFACE_LINK_LIBRARIES "${illumination_client_links}")
  endforeach ()
else ()
  message(STATUS "No units in labels, lamp handles and icons in ParaView's window: they need Qt Widgets and ParaView's client libraries.")
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

# The report is pure Python on top of ParaView's. In the build tree it is where it will be installed.
if (ILLUMINATION_WRAP_PYTHON)
  file(GLOB illumination_report CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/python/illumination_report/*.py"
    "${PROJECT_SOURCE_DIR}/python/illumination_report/*.html")
  set(illumination_report_folder "${CMAKE_BINARY_DIR}/${ILLUMINATION_PYTHON_DIR}/illumination_report")
  foreach (file IN LISTS illumination_report)
    get_filename_component(name "${file}" NAME)
    configure_file("${file}" "${illumination_report_folder}/${name}" COPYONLY)
  endforeach ()
  install(FILES ${illumination_report}
    DESTINATION "${ILLUMINATION_PYTHON_DIR}/illumination_report")
endif ()
