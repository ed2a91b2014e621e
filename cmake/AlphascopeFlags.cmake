# alphascope_flags: the INTERFACE target with the compile flags of every target.
add_library(alphascope_flags INTERFACE)
target_include_directories(alphascope_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(alphascope_flags INTERFACE
  # Position-independent also in programs, as a precompiled header serves only one kind of code.
  $<$<COMPILE_LANGUAGE:CXX>:-fPIC> $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-fPIC>
  # No fused multiply-add, as it rounds once. The error bounds of the filtered predicates assume two
  # roundings. So does the bitwise equality of CPU and GPU results.
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -Wall -Wextra -Wnon-virtual-dtor>
  # No -Wshadow where sources are combined: a local variable may shadow a private name of another
  # source.
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>>:-Wshadow>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns wrongly about "text" + std::string (PR 105651).
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
    # object-size finds accesses beyond an object, as AddressSanitizer does, and takes a tenth of
    # the compile time.
    target_compile_options(alphascope_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fno-sanitize=object-size>)
  endif()
endif()
