# SPDX-License-Identifier: GPL-3.0-or-later
# check_headers: compiles every header alone, so that none depends on includes before it. If a
# header's first include is another header, compiling it also tests that other one. So only headers
# that no header includes first are compiled here. The target is built on request only, right after
# configuring, which makes the list. Where headers of the standard library are precompiled,
# scripts/check_includes finds missing ones. With several headers of a folder in one source, this
# takes less than half of the time. A header can then use what an earlier one includes.
# scripts/check_includes finds such uses of types, but nothing finds those of functions.
add_custom_target(check_headers)
set(ALPHASCOPE_HEADERS_AT_ONCE 1 CACHE STRING "How many headers of a folder check_headers compiles in one source")

set(folders app core gpu ui)
list(TRANSFORM folders REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1/*.hpp")
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${folders})
set(ALPHASCOPE_FIRST_INCLUDES)
foreach(header IN LISTS headers)
  file(STRINGS ${header} include LIMIT_COUNT 1 REGEX "^#include \"")
  if(include MATCHES "\"(.+)\"")
    list(APPEND ALPHASCOPE_FIRST_INCLUDES ${CMAKE_MATCH_1})
  endif()
endforeach()

# Compiles FOLDER/*.hpp with the flags of TARGET.
function(alphascope_check_headers target folder)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  set(sources)
  set(count 0)
  foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} once REGEX "^#pragma once$")
    if(NOT once)
      message(FATAL_ERROR "${header} has no #pragma once, so it cannot be included twice")
    endif()
    if(header IN_LIST ALPHASCOPE_FIRST_INCLUDES)
      continue()
    endif()
    math(EXPR place "${count} % ${ALPHASCOPE_HEADERS_AT_ONCE}")
    math(EXPR count "${count} + 1")
    if(place EQUAL 0)
      set(source ${PROJECT_BINARY_DIR}/headers/${header}.cpp)
      list(APPEND sources ${source})
      set(text)
    endif()
    string(APPEND text "#include \"${header}\"\n")
    file(CONFIGURE OUTPUT ${source} CONTENT "${text}")
  endforeach()
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" name check_headers_${folder})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(${name} PRIVATE alphascope_flags)
  target_include_directories(${name} SYSTEM PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  target_compile_definitions(${name} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  target_compile_options(${name} PRIVATE -fsyntax-only)
  alphascope_precompile(${name})
  add_dependencies(check_headers ${name})
endfunction()
