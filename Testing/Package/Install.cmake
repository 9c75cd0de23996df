# SPDX-License-Identifier: BSD-3-Clause
file(REMOVE_RECURSE "${installed}" "${moved}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${build}" --prefix "${installed}" --config "${config}"
  OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${installed}" "${moved}")
