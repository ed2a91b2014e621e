# SPDX-License-Identifier: GPL-3.0-or-later
# alphascope_add_suites: makes each suite of a GoogleTest program one test of CTest. A process for
# each test would take longer: its start is a third of the time of a small window test. Run as a
# script (-P), this file lists a program's suites. Included, it defines the function.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${FILTER}
    OUTPUT_VARIABLE listed ERROR_VARIABLE errors RESULT_VARIABLE failed TIMEOUT 120)
  if(failed)
    message(FATAL_ERROR "${PROGRAM} does not list its tests (${failed}):\n${listed}${errors}")
  endif()
  string(REGEX REPLACE "[][;]" "" listed "${listed}")  # these characters would split CMake's lists
  string(REGEX MATCHALL "\n[^ \n][^\n]*\\.|\n  [^ \n]+" lines "\n${listed}")
  set(suite)
  set(tests)
  set(text)
  foreach(line IN LISTS lines ITEMS "\nend.")
    if(line MATCHES "^\n  (.+)")
      list(APPEND tests ${suite}.${CMAKE_MATCH_1})
      continue()
    endif()
    if(tests)
      list(LENGTH tests count)  # the largest suites start first
      list(JOIN tests ":" filter)
      string(APPEND text "add_test([=[${PREFIX}${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=])\n"
        "set_tests_properties([=[${PREFIX}${suite}]=] PROPERTIES COST ${count} ${PROPERTIES})\n")
    endif()
    string(REGEX REPLACE "^\n([^#]*)\\..*$" "\\1" suite "${line}")
    set(tests)
  endforeach()
  file(WRITE ${OUTPUT} "${text}")
  return()
endif()

# FILTER: GoogleTest's filter of the tests. PREFIX: prepended to their names. PROPERTIES: properties
# of the CTest tests.
function(alphascope_add_suites program)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "FILTER;PREFIX" "PROPERTIES")
  if(NOT of_FILTER)
    set(of_FILTER "*")
  endif()
  get_property(number TARGET ${program} PROPERTY ALPHASCOPE_SUITE_LISTS)
  math(EXPR number "0${number} + 1")
  set_property(TARGET ${program} PROPERTY ALPHASCOPE_SUITE_LISTS ${number})
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${program}-${number}.cmake)
  string(REPLACE ";" " " properties "${of_PROPERTIES}")
  add_custom_command(TARGET ${program} POST_BUILD BYPRODUCTS ${list}
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> "-DFILTER=${of_FILTER}" "-DPREFIX=${of_PREFIX}"
            "-DPROPERTIES=${properties}" -DOUTPUT=${list} -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    VERBATIM)
  # A program that was not built gives an error when tests run, as with GoogleTest's own functions.
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${program}-${number}-include.cmake)
  file(WRITE ${include} "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n"
    "  add_test(${program}_NOT_BUILT ${program}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()
