# SPDX-License-Identifier: BSD-3-Clause
# illumination_warnings(<target> [USES_VTK]): the warnings without which all hand-written code
# compiles. They are not errors by default: a compiler newer than ours must not stop a user's build
# (the preset `core` makes them errors). VTK's own macros are not pedantic.
function (illumination_warnings target)
  set(warnings -Wall -Wextra -Wshadow -Wconversion)
  if (NOT "USES_VTK" IN_LIST ARGN)
    list(APPEND warnings -Wpedantic)
  endif ()
  target_compile_options("${target}" PRIVATE
    "$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:${warnings}>")
endfunction ()
