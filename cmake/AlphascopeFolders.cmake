# SPDX-License-Identifier: GPL-3.0-or-later
# Lists the folders of the tree in their order, and the sources in them. So nobody has to keep a
# list of sources.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/folders ALPHASCOPE_FOLDERS REGEX "^[a-z]")
list(TRANSFORM ALPHASCOPE_FOLDERS REPLACE ":.*" "")

# alphascope_folders(OUT ROOT...): each ROOT and the folders below it, in their order.
function(alphascope_folders out)
  set(found)
  foreach(folder IN LISTS ALPHASCOPE_FOLDERS)
    foreach(root IN LISTS ARGN)
      if("${folder}/" MATCHES "^${root}/")
        list(APPEND found ${folder})
        break()
      endif()
    endforeach()
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# alphascope_sources(TARGET FOLDER... [EXCEPT SOURCE...]): adds the .cpp files in these folders, not in those
# below them, to TARGET. SOURCE is a path from the root.
function(alphascope_sources target)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "" "EXCEPT")
  foreach(folder IN LISTS of_UNPARSED_ARGUMENTS)
    file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
    if(of_EXCEPT AND sources)
      list(REMOVE_ITEM sources ${of_EXCEPT})
    endif()
    list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/)
    target_sources(${target} PRIVATE ${sources})
  endforeach()
endfunction()
