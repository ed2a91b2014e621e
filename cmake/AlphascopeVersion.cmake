# SPDX-License-Identifier: GPL-3.0-or-later
# alphascope_version: writes the program's version and commit, and a hash of the sources of core,
# gpu and net, at each build when they have changed. Run as a script (-P), this file writes the source.
# Included, it makes the target.
if(CMAKE_SCRIPT_MODE_FILE)
  # The folder may lie inside the repository of a packager or of another project, whose commit would
  # be wrong. An archive made by git names its own commit, and comes first. Otherwise git is asked
  # only if the folder is the root of its work tree.
  set(commit "unknown")
  file(STRINGS ${SOURCE_DIR}/cmake/archive_commit archived LIMIT_COUNT 1)
  if(archived MATCHES "^([0-9a-f]+)(-dirty)?$")
    string(SUBSTRING ${CMAKE_MATCH_1} 0 12 commit)
    string(APPEND commit "${CMAKE_MATCH_2}")
  else()
    execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --show-cdup
      OUTPUT_VARIABLE up RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed AND up STREQUAL "")
      execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
        OUTPUT_VARIABLE described RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
      if(NOT failed)
        set(commit "${described}")
      endif()
    endif()
  endif()
  file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR}
    ${SOURCE_DIR}/core/*.[ch]pp ${SOURCE_DIR}/gpu/*.[ch]pp ${SOURCE_DIR}/gpu/*.cu ${SOURCE_DIR}/gpu/*.cuh
    ${SOURCE_DIR}/net/*.[ch]pp)
  list(SORT sources)
  set(hashes)
  foreach(source IN LISTS sources)
    file(SHA256 ${SOURCE_DIR}/${source} hash)
    string(APPEND hashes "${source} ${hash}\n")
  endforeach()
  string(SHA256 hash "${hashes}")
  string(SUBSTRING ${hash} 0 16 hash)
  file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "app/session/version.hpp"
#include "core/run/library_build.hpp"

#ifdef __clang__
#define ALPHASCOPE_COMPILER "clang " __clang_version__
#else
#define ALPHASCOPE_COMPILER "GCC " __VERSION__
#endif

namespace alphascope {
std::string_view program_version() { return "@VERSION@"; }
std::string_view program_commit() { return "@commit@"; }
const char* library_build() { return "@VERSION@ @hash@ " ALPHASCOPE_COMPILER; }
}  // namespace alphascope
]] @ONLY)
  return()
endif()

set(version_source ${PROJECT_BINARY_DIR}/generated/version.cpp)
add_custom_target(alphascope_version_source
  COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DOUTPUT=${version_source}
          -DVERSION=${PROJECT_VERSION} -P ${CMAKE_CURRENT_LIST_FILE}
  BYPRODUCTS ${version_source}
  COMMENT "Looking up version and commit" VERBATIM)
add_library(alphascope_version STATIC ${version_source})
add_dependencies(alphascope_version alphascope_version_source)
target_link_libraries(alphascope_version PUBLIC alphascope_flags)
