# SPDX-License-Identifier: BSD-3-Clause
# `cpack` in a build folder makes a Debian package of what is built there: the plugin, the libraries, the
# Python module, and headers and CMake files for C++ projects.
if (NOT ILLUMINATION_WITH_PARAVIEW OR NOT EXISTS /etc/debian_version)
  return ()
endif ()

# ParaView lists the plugins that its file paraview.conf names, and loads those that its user ticks. Debian 13's names
# a folder for the plugins of other packages. Debian 12 has no such file, so that its ParaView does not even list its
# own plugins; the package brings one beside the programs, for both.
set(illumination_conf "")
set(illumination_plugin_folder "")
set(illumination_debians_conf "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/${PARAVIEW_PLUGIN_SUBDIR}/../paraview.conf")
if (EXISTS "${illumination_debians_conf}")
  file(STRINGS "${illumination_debians_conf}" illumination_plugin_folder REGEX "^/usr/share/" LIMIT_COUNT 1)
endif ()
if (NOT illumination_plugin_folder)
  set(illumination_conf "${CMAKE_CURRENT_BINARY_DIR}/paraview.conf")
  file(WRITE "${illumination_conf}"
    "../lib/${CMAKE_LIBRARY_ARCHITECTURE}/${PARAVIEW_PLUGIN_SUBDIR}/paraview.plugins.xml\n"
    "../${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/illumination.plugins.xml\n")
endif ()

file(STRINGS /etc/os-release illumination_release REGEX "^VERSION_ID=")
string(REGEX REPLACE "[^0-9.]" "" illumination_release "${illumination_release}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME illumination-maps)
set(CPACK_PACKAGE_CONTACT "The Illumination Maps authors <illumination-maps@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "illumination maps of surfaces, for ParaView and VTK")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~deb${illumination_release}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Without Qt's SVG engine ParaView's window has no icons, neither its own nor ours.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "python3-paraview, libqt${PARAVIEW_QT_MAJOR_VERSION}svg${PARAVIEW_QT_MAJOR_VERSION}")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/DebianLayout.cmake")
# What the script needs to know.
set(CPACK_ILLUMINATION_PYTHON_DIR "${ILLUMINATION_PYTHON_DIR}")
set(CPACK_ILLUMINATION_CONF "${illumination_conf}")
set(CPACK_ILLUMINATION_PLUGIN_FOLDER "${illumination_plugin_folder}")
set(CPACK_ILLUMINATION_PLUGIN "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/IlluminationMaps")
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # what is not installed need not be built
include(CPack)
