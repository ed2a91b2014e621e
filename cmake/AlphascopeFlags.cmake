# SPDX-License-Identifier: GPL-3.0-or-later
# alphascope_flags: the INTERFACE target with the compile flags of every target.
add_library(alphascope_flags INTERFACE)
target_include_directories(alphascope_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(alphascope_flags INTERFACE
  # Code of programs is position-independent too, because a precompiled header fits only one kind of
  # code.
  $<$<COMPILE_LANGUAGE:CXX>:-fPIC> $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-fPIC>
  # Fused multiply-add is off, because it rounds once. The error bounds of filtered predicates
  # assume two roundings, and the equality of CPU and GPU results needs them.
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -Wall -Wextra -Wnon-virtual-dtor>
  # -Wshadow is off where sources are combined. A local variable may then shadow a private name of
  # another source.
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>>:-Wshadow>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns wrongly about "text" + std::string (PR 105651).
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects garbage from 400 MB instead of 128 MB on, which saves 5 % of its time.
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=400000>)
endif()
if(ALPHASCOPE_STRICT)
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(ALPHASCOPE_BUILD_FUZZERS)
  # Counters for fuzzers, in the functions of that list only. Other programs ignore them.
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>
    $<$<COMPILE_LANGUAGE:CXX>:-fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/tests/fuzz/steered_by>)
endif()
if(ALPHASCOPE_SANITIZER)
  target_compile_options(alphascope_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${ALPHASCOPE_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all>)
  target_link_options(alphascope_flags INTERFACE -fsanitize=${ALPHASCOPE_SANITIZER})
  if(ALPHASCOPE_SANITIZER MATCHES "address")
    # A program at a fixed place starts in two thirds of the time, because 800,000 addresses in it
    # need no change.
    target_link_options(alphascope_flags INTERFACE
      $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
  endif()
  if(ALPHASCOPE_SANITIZER MATCHES "address.*undefined")
    # object-size finds accesses beyond an object, as AddressSanitizer does, and takes a tenth of
    # the compile time.
    target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fno-sanitize=object-size>)
  endif()
endif()
