# SPDX-License-Identifier: BSD-3-Clause
# Where things go, in the build tree and (the same below its prefix) in the install tree, and
# the CMake package IlluminationMaps that makes the install tree usable from other projects.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(ILLUMINATION_INCLUDE_DIR "${CMAKE_INSTALL_INCLUDEDIR}/IlluminationMaps")
set(ILLUMINATION_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/IlluminationMaps")

set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")

# The installed libraries find each other relative to themselves, so that the tree can be moved.
set(CMAKE_INSTALL_RPATH "$ORIGIN")

function (illumination_install_package)
  install(EXPORT PhotonTransport
    NAMESPACE Illumination::
    FILE PhotonTransport-targets.cmake
    DESTINATION "${ILLUMINATION_CMAKE_DIR}")
  # VTK exports its modules from the build tree too, and a static one with the core that it needs.
  export(EXPORT PhotonTransport
    NAMESPACE Illumination::
    FILE "${CMAKE_BINARY_DIR}/${ILLUMINATION_CMAKE_DIR}/PhotonTransport-targets.cmake")
  configure_package_config_file(
    "${PROJECT_SOURCE_DIR}/cmake/IlluminationMapsConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/IlluminationMapsConfig.cmake"
    INSTALL_DESTINATION "${ILLUMINATION_CMAKE_DIR}")
  write_basic_package_version_file(
    "${CMAKE_CURRENT_BINARY_DIR}/IlluminationMapsConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion) # before 1.0 a minor version may change names
  install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/IlluminationMapsConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/IlluminationMapsConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/IlluminationFindVTK.cmake"
    DESTINATION "${ILLUMINATION_CMAKE_DIR}")
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/IlluminationMaps")
endfunction ()
