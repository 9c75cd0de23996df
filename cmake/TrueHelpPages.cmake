# SPDX-License-Identifier: BSD-3-Clause
# cmake -DFOLDER=<of the help pages> -P: takes out what is not true. ParaView's style sheet
# (paraview_servermanager_convert_xml.xsl, template InputArrayDomain) says of each domain that lists
# arrays that the input must have one, also where the domain is optional. All of ours for cell arrays
# are. The suggested lamp is no filter for users.
file(REMOVE "${FOLDER}/internal_ufilters.SuggestedLamp.html")
file(GLOB pages "${FOLDER}/*.html")
foreach (page IN LISTS pages)
  file(READ "${page}" text)
  string(REGEX REPLACE
    "<p>[ \n]*The dataset must contain a field array \\(cell\\)[ \n]*(with [0-9,]+ component\\(s\\)\\.)?[ \n]*</p>[ \n]*"
    "" true_text "${text}")
  if (NOT true_text STREQUAL text)
    file(WRITE "${page}" "${true_text}")
  endif ()
endforeach ()
