# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the documentation and the licences, in the component `data`. The docs are in a folder of
# the program's own, because a program may not depend on share/doc: distributions compress or leave
# out files there. share/doc has a link to them.
include(GNUInstallDirs)
set(docs ${CMAKE_INSTALL_DATADIR}/alphascope/docs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${docs} COMPONENT data)
file(RELATIVE_PATH from_doc /prefix/${CMAKE_INSTALL_DOCDIR} /prefix/${docs})
install(CODE "
  set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\")
  file(MAKE_DIRECTORY \"\${folder}\")
  file(CREATE_LINK ${from_doc} \"\${folder}/docs\" SYMBOLIC)" COMPONENT data)
# README.md and CHANGELOG.md find the docs by the same links as in the source tree.
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md SECURITY.md LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data)
# Docs link to these, too. The test Desktop checks all links of the installed docs.
install(FILES scripts/packages.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}/scripts COMPONENT data)
install(FILES tests/devel/CMakeLists.txt tests/devel/user.cpp DESTINATION ${CMAKE_INSTALL_DOCDIR}/tests/devel COMPONENT data)
# The program contains the fonts. ORIGINS.md tells where fonts and molecules come from.
install(FILES resources/ORIGINS.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources COMPONENT data)
install(FILES resources/fonts/OFL.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources/fonts COMPONENT data)

# alphascope_link_resources(FOLDER): gives FOLDER links to resources and docs of the source tree, as
# an installation has them.
function(alphascope_link_resources folder)
  if(IS_SYMLINK ${folder})  # a build folder from before the docs were among them
    file(REMOVE ${folder})
  endif()
  file(MAKE_DIRECTORY ${folder})
  foreach(name lessons molecules sandbox)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/resources/${name} ${folder}/${name} SYMBOLIC)
  endforeach()
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs ${folder}/docs SYMBOLIC)
endfunction()
