# SPDX-License-Identifier: BSD-3-Clause
# Run by cpack on the files of the package: puts two things where Debian looks for them. Elsewhere the
# Python module's place follows VTK's default, and the folder of ParaView's programs is not ours.
set(usr "${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}")
if (CPACK_ILLUMINATION_PYTHON_DIR)
  # As many folders below the libraries as before, so that the module still finds them.
  file(MAKE_DIRECTORY "${usr}/lib/python3")
  file(RENAME "${usr}/${CPACK_ILLUMINATION_PYTHON_DIR}" "${usr}/lib/python3/dist-packages")
  string(REGEX REPLACE "/[^/]*$" "" emptied "${CPACK_ILLUMINATION_PYTHON_DIR}")
  file(REMOVE_RECURSE "${usr}/${emptied}")
endif ()
if (CPACK_ILLUMINATION_PLUGIN_FOLDER)
  set(folder "${CPACK_TEMPORARY_INSTALL_DIRECTORY}${CPACK_ILLUMINATION_PLUGIN_FOLDER}")
  file(MAKE_DIRECTORY "${folder}")
  file(CREATE_LINK "${CPACK_ILLUMINATION_PLUGIN}" "${folder}/IlluminationMaps" SYMBOLIC)
else ()
  file(COPY "${CPACK_ILLUMINATION_CONF}" DESTINATION "${usr}/bin")
endif ()
