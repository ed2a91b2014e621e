# SPDX-License-Identifier: GPL-3.0-or-later
# Installs core as a library for other programs, in the component devel: `cmake --install BUILD
# --component devel`. Such a program includes <alphascope/engine/engine.hpp> for
# core/engine/engine.hpp. It calls find_package(alphascope) and links alphascope::core. It gets none
# of our compile flags.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Headers name each other from the root of the tree, as "core/…"; installed ones as "alphascope/…".
alphascope_folders(folders core)
list(FILTER folders EXCLUDE REGEX "^core/document/")
string(CONFIGURE [[
  foreach(folder @folders@)
    file(GLOB headers "@PROJECT_SOURCE_DIR@/${folder}/*.hpp")
    string(REGEX REPLACE "^core/" "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/@CMAKE_INSTALL_INCLUDEDIR@/alphascope/" to "${folder}")
    foreach(header IN LISTS headers)
      cmake_path(GET header FILENAME name)
      file(READ "${header}" text)
      string(REPLACE "\n#include \"core/" "\n#include \"alphascope/" text "${text}")
      file(WRITE "${to}/${name}" "${text}")
    endforeach()
  endforeach()
]] install_headers @ONLY)
install(CODE "${install_headers}" COMPONENT devel EXCLUDE_FROM_ALL)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/alphascope)
set_target_properties(alphascope_core PROPERTIES EXPORT_NAME core)
install(TARGETS alphascope_core EXPORT alphascope
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT devel EXCLUDE_FROM_ALL
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT alphascope NAMESPACE alphascope:: FILE alphascopeTargets.cmake
  DESTINATION ${package} COMPONENT devel EXCLUDE_FROM_ALL)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/package/alphascopeConfig.cmake @ONLY CONTENT [[
include(CMakeFindDependencyMacro)
find_dependency(TBB)
find_dependency(ZLIB)
find_dependency(hwy)
include("${CMAKE_CURRENT_LIST_DIR}/alphascopeTargets.cmake")
]])
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/alphascopeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(DIRECTORY ${PROJECT_BINARY_DIR}/package/ DESTINATION ${package} COMPONENT devel EXCLUDE_FROM_ALL)
# For programs that are built without CMake.
file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/alphascope.pc @ONLY CONTENT [[
prefix=${pcfiledir}/@to_prefix@
Name: alphascope
Description: exact alpha complexes of molecules
Version: @PROJECT_VERSION@
Requires: tbb zlib gmp libhwy
Cflags: -I${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
Libs: -L${prefix}/@CMAKE_INSTALL_LIBDIR@ -lalphascope_core -ltbbmalloc
]])
install(FILES ${PROJECT_BINARY_DIR}/alphascope.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT devel EXCLUDE_FROM_ALL)
