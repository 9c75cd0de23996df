# SPDX-License-Identifier: BSD-3-Clause
# Finding VTK and ParaView where find_package alone does not suffice. Shared by this build and by
# the installed CMake package, whose users meet the same systems.

# illumination_locate(<package> <variable>): the folder of the CMake files that find_package would
# read for <package>, without reading them. No version is new enough for this call, so all that
# find_package does is to list what it considered.
function (illumination_locate package variable)
  set(folder "${${package}_DIR}")
  if (NOT folder)
    find_package("${package}" 99999 QUIET CONFIG)
    unset("${package}_DIR" CACHE)
    if (${package}_CONSIDERED_CONFIGS)
      list(GET ${package}_CONSIDERED_CONFIGS 0 folder)
      get_filename_component(folder "${folder}" DIRECTORY)
    endif ()
  endif ()
  set("${variable}" "${folder}" PARENT_SCOPE)
endfunction ()

# illumination_stand_in_for_python_targets(<folder>): Debian 13 installs ParaView's Python modules
# as vtkX.cpython-*.so, but the CMake files in <folder> ask for vtkX.so and stop because it is
# missing. They also return at once when their targets exist already. Nothing here links to these
# targets, so empty ones stand in for them. Where the files are in place this does nothing.
function (illumination_stand_in_for_python_targets folder)
  string(REGEX REPLACE "/lib[^/]*/.*" "" prefix "${folder}")
  file(GLOB targets_files "${folder}/*Python*-targets.cmake")
  foreach (targets_file IN LISTS targets_files)
    string(REGEX REPLACE "\\.cmake$" "-*.cmake" configurations "${targets_file}")
    file(GLOB configurations "${configurations}")
    foreach (configuration IN LISTS configurations)
      file(STRINGS "${configuration}" modules REGEX "IMPORTED_LOCATION_.*dist-packages")
      string(REGEX MATCH "dist-packages/[^\"]*" module "${modules}")
      if (NOT module OR EXISTS "${prefix}/lib/python3/${module}")
        continue ()
      endif ()
      message(STATUS "${prefix}/lib/python3/${module} is missing: standing in for ${targets_file}")
      file(STRINGS "${targets_file}" names REGEX "^foreach ?\\(_cmake_expected_target IN ITEMS ")
      string(REGEX MATCHALL "[A-Za-z0-9_]+::[A-Za-z0-9_]+" names "${names}")
      foreach (name IN LISTS names)
        if (NOT TARGET "${name}")
          add_library("${name}" INTERFACE IMPORTED)
        endif ()
      endforeach ()
    endforeach ()
  endforeach ()
endfunction ()

# illumination_find_paraview(...), illumination_find_vtk(...): find_package(<package> ...) with the
# above. A VTK inside ParaView serves where there is no other.
macro (illumination_find_paraview)
  illumination_locate(ParaView illumination_paraview)
  illumination_stand_in_for_python_targets("${illumination_paraview}")
  illumination_stand_in_for_python_targets("${illumination_paraview}/vtk")
  find_package(ParaView ${ARGV})
endmacro ()

macro (illumination_find_vtk)
  illumination_locate(VTK illumination_vtk)
  illumination_locate(ParaView illumination_paraview)
  # From the second configuration on the VTK inside ParaView is in the cache as if it were its own.
  if (NOT illumination_vtk OR illumination_vtk STREQUAL "${illumination_paraview}/vtk")
    illumination_stand_in_for_python_targets("${illumination_paraview}/vtk")
  endif ()
  find_package(VTK ${ARGV} PATHS "${illumination_paraview}/vtk")
endmacro ()
