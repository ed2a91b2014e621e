# alphascope_flags: the one INTERFACE target that carries how every target is compiled.
add_library(alphascope_flags INTERFACE)
target_include_directories(alphascope_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(alphascope_flags INTERFACE
  # A fused multiply-add rounds once where the error bounds of the filtered predicates and the
  # byte-equality of CPU and GPU results assume two roundings.
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -Wall -Wextra -Wnon-virtual-dtor>
  # Where sources are combined, a local variable shadows what a neighbour has for itself.
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>>:-Wshadow>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of "text" + std::string by mistake (PR 105651).
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
if(ALPHASCOPE_STRICT)
  target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(ALPHASCOPE_SANITIZER)
  target_compile_options(alphascope_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${ALPHASCOPE_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all>)
  target_link_options(alphascope_flags INTERFACE -fsanitize=${ALPHASCOPE_SANITIZER})
  if(ALPHASCOPE_SANITIZER MATCHES "address.*undefined")
    # It looks for accesses beyond an object, as AddressSanitizer does, and takes a tenth of the time to
    # compile.
    target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fno-sanitize=object-size>)
  endif()
endif()
