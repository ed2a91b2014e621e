# check_headers: compiles every header of a folder alone, so that none leans on what was included
# before it. Built on request only.
add_custom_target(check_headers)

# Compiles FOLDER/*.hpp as sources of TARGET would be.
function(alphascope_check_headers target folder)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  set(sources)
  foreach(header IN LISTS headers)
    set(source ${PROJECT_BINARY_DIR}/headers/${header}.cpp)
    # Twice: the second inclusion must do nothing.
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n#include \"${header}\"\n")
    list(APPEND sources ${source})
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
  add_dependencies(check_headers ${name})
endfunction()
