# SPDX-License-Identifier: BSD-3-Clause
# illumination_warnings(<target>): the warnings that all hand-written code compiles without.
# They are not errors by default: a compiler newer than ours must not stop a user's build
# (CMAKE_COMPILE_WARNING_AS_ERROR, which the tests set for the core, makes them errors).
function (illumination_warnings target)
  target_compile_options("${target}" PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion>)
endfunction ()
