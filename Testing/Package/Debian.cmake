# SPDX-License-Identifier: BSD-3-Clause
file(REMOVE_RECURSE "${folder}")
file(MAKE_DIRECTORY "${folder}")
execute_process(
  COMMAND "${cpack}" --config "${build}/CPackConfig.cmake" -C "${config}" -B "${folder}"
  OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package "${folder}/illumination-maps_*.deb")
execute_process(COMMAND dpkg-deb -x "${package}" "${folder}/root" COMMAND_ERROR_IS_FATAL ANY)

# Where ParaView has no folder for the plugins of other packages, a file beside its programs names two lists of
# plugins, of which the second is the package's.
file(GLOB_RECURSE ours "${folder}/root/usr/lib*/illumination.plugins.xml")
set(in_folder "${folder}/root/usr/share/paraview/plugins/IlluminationMaps")
if (EXISTS "${folder}/root/usr/bin/paraview.conf")
  file(STRINGS "${folder}/root/usr/bin/paraview.conf" lists)
  list(LENGTH lists number)
  list(GET lists 1 second)
  file(REAL_PATH "${folder}/root/usr/bin/${second}" second)
  if (NOT number EQUAL 2 OR NOT second STREQUAL ours)
    message(FATAL_ERROR "paraview.conf names ${lists}")
  endif ()
elseif (NOT IS_SYMLINK "${in_folder}")
  message(FATAL_ERROR "nothing tells ParaView of the plugin")
endif ()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH "PV_PLUGIN_CONFIG_FILE=${ours}"
    "PYTHONPATH=${folder}/root/usr/lib/python3/dist-packages"
    "${pvpython}" "${CMAKE_CURRENT_LIST_DIR}/debian_user.py"
  COMMAND_ERROR_IS_FATAL ANY)
