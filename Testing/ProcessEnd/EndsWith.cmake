# SPDX-License-Identifier: BSD-3-Clause
# Runs CHILD (words separated by |) five times: each must end with STATUS within 30 seconds, most of
# which a busy machine takes to start ParaView.
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
