# SPDX-License-Identifier: BSD-3-Clause
# Runs a script in ParaView's window with settings of its own. The script leaves a file with what failed;
# ParaView itself ends with status 0 whatever a script does.
string(REPLACE "|" ";" command "${PARAVIEW}")
set(ENV{ILLUMINATION_WINDOW_RESULT} "${FOLDER}/failed.txt")
set(ENV{XDG_CONFIG_HOME} "${FOLDER}/settings")
file(REMOVE_RECURSE "${FOLDER}/failed.txt" "${FOLDER}/settings")
file(MAKE_DIRECTORY "${FOLDER}/settings")
execute_process(COMMAND ${command} "--script=${SCRIPT}" TIMEOUT 170 RESULT_VARIABLE status)
if (NOT EXISTS "${FOLDER}/failed.txt")
  message(FATAL_ERROR "The script did not come to its end (status ${status}).")
endif ()
file(READ "${FOLDER}/failed.txt" failed)
if (failed OR NOT status EQUAL 0)
  message(FATAL_ERROR "Status ${status}. ${failed}")
endif ()
