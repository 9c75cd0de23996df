# SPDX-License-Identifier: BSD-3-Clause
# All C++ is laid out as .clang-format says. To mend it: clang-format -i on the files named here.
file(GLOB_RECURSE files
  "${source}/filters/*.h" "${source}/filters/*.cxx" "${source}/plugin/*.h" "${source}/plugin/*.cxx"
  "${source}/Testing/*.h" "${source}/Testing/*.cxx")
execute_process(
  COMMAND "${clang_format}" --dry-run -Werror ${files}
  RESULT_VARIABLE result)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "Some files are not formatted.")
endif ()
