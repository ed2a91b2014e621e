# Most of the time to compile a source goes into templates of the standard library that its neighbours
# need as well: compiled a dozen at a time, core/, app/ and ui/ take half as long. What sources lean on
# then is not noticed here, but by the preset tsan, by check_headers, and wherever this is off.
# By default not with ccache, which then finds a source again only when its neighbours are the same.
set(by_default ON)
# Nor for ThreadSanitizer, nor where every warning counts: one build has to compile each source alone.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache" OR ALPHASCOPE_STRICT OR
   ALPHASCOPE_SANITIZER STREQUAL "thread")
  set(by_default OFF)
endif()
option(ALPHASCOPE_UNITY "Compile several sources at once" ${by_default})

# The names that TEXT declares at the start of a line, which is where clang-format puts them. Too many do
# no harm.
function(alphascope_declared_names text names)
  string(REGEX REPLACE "[][;]" "=" text "\n${text}")  # these would take CMake's lists apart
  string(REGEX MATCHALL "\n[A-Za-z#][^\n]*" lines "${text}")
  set(found)
  foreach(line IN LISTS lines)
    if(line MATCHES "^\n(struct|class|enum class|enum|union|using|#define) ([A-Za-z0-9_]+)")
      list(APPEND found ${CMAKE_MATCH_2})
    elseif(line MATCHES "^\n[^(={]*[ *&]([A-Za-z0-9_]+) ?[(={]")
      list(APPEND found ${CMAKE_MATCH_1})
      if(line MATCHES ", [*&]?([A-Za-z0-9_]+) =")  # constexpr int kOne = 1, kTwo = 2
        string(REGEX MATCHALL ", [*&]?[A-Za-z0-9_]+ =" more "${line}")
        list(TRANSFORM more REPLACE ", [*&]?([A-Za-z0-9_]+) =" "\\1")
        list(APPEND found ${more})
      endif()
    endif()
  endforeach()
  set(${names} "${found}" PARENT_SCOPE)
endfunction()

# Those that a source has for itself, in namespaces without a name.
function(alphascope_private_names source names)
  file(READ ${source} text)
  set(found)
  string(FIND "${text}" "\nnamespace {\n" at)
  while(at GREATER_EQUAL 0)
    math(EXPR at "${at} + 13")
    string(SUBSTRING "${text}" ${at} -1 text)
    string(FIND "${text}" "\n}  // namespace\n" end)
    string(SUBSTRING "${text}" 0 ${end} inside)
    alphascope_declared_names("${inside}" some)
    list(APPEND found ${some})
    string(FIND "${text}" "\nnamespace {\n" at)
  endwhile()
  string(REGEX MATCHALL "\n#define [A-Za-z0-9_]+" macros "${text}")
  list(TRANSFORM macros REPLACE "\n#define " "")
  set(${names} ${found} ${macros} PARENT_SCOPE)
endfunction()

# Combines sources of TARGET, at most SIZE and of one folder: never two that have a name each for
# themselves, and none that has one for itself that a header has as well.
function(alphascope_unity target size)
  if(NOT ALPHASCOPE_UNITY)
    return()
  endif()
  get_property(taken GLOBAL PROPERTY ALPHASCOPE_HEADER_NAMES)
  if(NOT taken)
    file(GLOB_RECURSE headers ${PROJECT_SOURCE_DIR}/app/*.hpp ${PROJECT_SOURCE_DIR}/core/*.hpp
      ${PROJECT_SOURCE_DIR}/ui/*.hpp)
    foreach(header IN LISTS headers)
      file(READ ${header} text)
      alphascope_declared_names("${text}" some)
      list(APPEND taken ${some})
    endforeach()
    list(REMOVE_DUPLICATES taken)
    set_property(GLOBAL PROPERTY ALPHASCOPE_HEADER_NAMES "${taken}")
  endif()

  get_target_property(sources ${target} SOURCES)
  get_target_property(target_folder ${target} SOURCE_DIR)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "\\$<")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${target_folder})
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
    cmake_path(GET folder PARENT_PATH folder)
    if(folder MATCHES "^\\.\\." OR (folder MATCHES "${ALPHASCOPE_TIMED}" AND NOT ALPHASCOPE_SANITIZER))
      continue()
    endif()
    alphascope_private_names(${source} names)
    set(clashes ${names})
    list(REMOVE_ITEM clashes ${taken})
    if(NOT "${clashes}" STREQUAL "${names}")
      continue()
    endif()
    string(REPLACE "/" "_" folder ${folder})
    set(n 1)
    while(TRUE)  # the first group with room and without these names
      set(group ${folder}_${n})
      list(LENGTH members_${group} members)
      set(rest ${names})
      if(names AND names_${group})
        list(REMOVE_ITEM rest ${names_${group}})
      endif()
      if(members LESS size AND "${rest}" STREQUAL "${names}")
        break()
      endif()
      math(EXPR n "${n} + 1")
    endwhile()
    list(APPEND members_${group} ${source})
    list(APPEND names_${group} ${names})
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A local variable shadows what a neighbour has for itself. And GCC takes an included source for a
  # header, whose classes should have no member of a private type.
  target_compile_options(${target} PRIVATE -Wno-shadow
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# Code that decides the times in docs/performance.md is optimised as it always was: source by source.
set(ALPHASCOPE_TIMED
  "^core/(predicates|neighbours|complex|engine|triangulation|dual_edge|tuples|engines|measure|verify)$")
