# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what a desktop knows a program by: its entry, icons, types of files, thumbnails and
# metadata. They are the component `desktop`. resources/desktop/alphascope.xml has the only list of
# types; the other files are made with it.
include(GNUInstallDirs)
set(from ${PROJECT_SOURCE_DIR}/resources/desktop)
set(made ${PROJECT_BINARY_DIR}/desktop)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from}/alphascope.xml)
file(STRINGS ${from}/alphascope.xml types REGEX "<mime-type type=")
list(TRANSFORM types REPLACE ".*type=\"([^\"]+)\".*" "\\1")
set(types_with_semicolons "${types};")
list(TRANSFORM types REPLACE "(.+)" "    <mediatype>\\1</mediatype>" OUTPUT_VARIABLE types_as_elements)
list(JOIN types_as_elements "\n" types_as_elements)
set(releases "")
if(ALPHASCOPE_DATE)
  set(releases "  <releases>\n    <release version=\"${PROJECT_VERSION}\" type=\"${ALPHASCOPE_RELEASE}\" date=\"${ALPHASCOPE_DATE}\"/>\n  </releases>")
endif()
# Software centres load pictures from the web. docs/images has them, and scripts/docs_site's site.
set(ALPHASCOPE_HOME_PAGE "" CACHE STRING "Address of the published site, for the metadata; without it they have no pictures")
set(pictures "")
if(ALPHASCOPE_HOME_PAGE)
  string(REGEX REPLACE "/+$" "" home_page "${ALPHASCOPE_HOME_PAGE}")
  set(kind " type=\"default\"")
  foreach(picture "cavity|A cavity with its ligand" "channel|A channel with its profile"
      "timings|Timings beside those of CGAL" "lesson|A lesson")
    string(REPLACE "|" ";" picture ${picture})
    list(POP_FRONT picture name caption)
    string(APPEND pictures "    <screenshot${kind}>\n      <caption>${caption}</caption>\n"
      "      <image>${home_page}/docs/images/${name}.png</image>\n    </screenshot>\n")
    set(kind "")
  endforeach()
  set(pictures "  <url type=\"homepage\">${home_page}/</url>\n  <screenshots>\n${pictures}  </screenshots>")
endif()
set(thumbnail_folder ${CMAKE_INSTALL_FULL_LIBEXECDIR}/alphascope)
file(RELATIVE_PATH to_bin /prefix/${CMAKE_INSTALL_LIBEXECDIR}/alphascope /prefix/${CMAKE_INSTALL_BINDIR})

function(alphascope_desktop_file name to folder)  # made from NAME.in
  configure_file(${from}/${name}.in ${made}/${to} @ONLY)
  install(FILES ${made}/${to} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT desktop)
endfunction()
alphascope_desktop_file(alphascope.desktop alphascope.desktop applications)
alphascope_desktop_file(alphascope.thumbnailer alphascope.thumbnailer thumbnailers)
alphascope_desktop_file(alphascope.metainfo.xml org.alphascope.alphascope.metainfo.xml metainfo)
install(FILES ${from}/alphascope.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT desktop)
configure_file(${from}/thumbnail.in ${made}/thumbnail @ONLY)
install(PROGRAMS ${made}/thumbnail DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/alphascope COMPONENT desktop)

set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
foreach(size 16 24 32 48 64 128 256 512)
  install(FILES ${from}/icons/${size}.png DESTINATION ${icons}/${size}x${size}/apps RENAME alphascope.png
    COMPONENT desktop)
endforeach()
install(FILES ${from}/icons/alphascope.svg DESTINATION ${icons}/scalable/apps COMPONENT desktop)
