# SPDX-License-Identifier: BSD-3-Clause
# Runs CHILD (words separated by |) five times: each must end with STATUS within 30 seconds, most of
# which a busy machine takes to start ParaView. Leaves RESULT, an XML file, for the table of Testing/README.md:
# the way out, WAY, is a row's entry of what was measured, and WHAT is the row.
file(REMOVE "${RESULT}")
string(REPLACE "|" ";" command "${CHILD}")
foreach (time RANGE 1 5)
  execute_process(COMMAND ${command}
    TIMEOUT 30 RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if (STATUS STREQUAL "SIGTERM" AND status MATCHES "[Tt]erminated")
    continue () # CMake's name for that end
  endif ()
  if (NOT status STREQUAL STATUS)
    message(FATAL_ERROR "run ${time} ended with '${status}', not '${STATUS}':\n${said}")
  endif ()
endforeach ()
file(WRITE "${RESULT}"
  "<testsuites><testcase classname=\"ProcessEnd\" name=\"${WHAT}\" status=\"run\"><properties>"
  "<property name=\"protects\" value=\"a process that has used the filter: it dies or hangs at its end\"/>"
  "<property name=\"measured\" value=\"${WAY}: ${STATUS}\"/>"
  "</properties></testcase></testsuites>\n")
