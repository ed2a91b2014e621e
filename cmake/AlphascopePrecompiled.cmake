# SPDX-License-Identifier: GPL-3.0-or-later
# Precompiled headers. Reading the standard library took a quarter of the compile time of core/,
# app/ and ui/; now it is read once. No source may depend on it: scripts/check_includes finds such
# sources. Off by default with ccache, because ccache then finds no results of other build folders.
# The presets ci, asan and tsan always precompile.
set(by_default ON)
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(by_default OFF)
endif()
option(ALPHASCOPE_PRECOMPILE "Read the standard library's headers once" ${by_default})

# alphascope_precompile(TARGET): precompiles the headers of one target.
function(alphascope_precompile target)
  if(NOT ALPHASCOPE_PRECOMPILE OR NOT CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang)$")
    return()
  endif()
  set(quiet)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC wrongly warns about precompiled "text" + std::string in three more ways
    # (AlphascopeFlags.cmake).
    set(quiet -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
  # Precompiled headers fit one level of optimisation only. So glue needs headers of its own.
  set(headers alphascope_headers)
  get_target_property(glue ${target} ALPHASCOPE_GLUE)
  if(glue)
    set(headers alphascope_headers_of_glue)
  endif()
  if(NOT TARGET ${headers})
    set(source ${PROJECT_BINARY_DIR}/headers/none.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${headers} OBJECT ${source})
    target_link_libraries(${headers} PRIVATE alphascope_flags)
    target_compile_options(${headers} PRIVATE ${quiet})
    if(glue)
      target_compile_options(${headers} PRIVATE ${ALPHASCOPE_GLUE_OPTIMIZATION})
    endif()
    # <iostream> is left out, since every source would then initialise it.
    target_precompile_headers(${headers} PRIVATE <algorithm> <array> <atomic> <charconv> <chrono>
      <cmath> <condition_variable> <cstdint> <cstdio> <cstring> <filesystem> <functional> <limits> <map>
      <memory> <mutex> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread>
      <unordered_map> <utility> <vector>)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
  target_compile_options(${target} PRIVATE ${quiet})
endfunction()

# alphascope_precompiled(FOLDER): precompiles for the targets of this folder and of those below it.
function(alphascope_precompiled folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(kind ${target} TYPE)
    if(kind MATCHES "^(EXECUTABLE|STATIC_LIBRARY|OBJECT_LIBRARY)$")
      alphascope_precompile(${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    alphascope_precompiled(${below})
  endforeach()
endfunction()
