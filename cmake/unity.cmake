# SPDX-License-Identifier: Apache-2.0
# With GLINT_FILES_TOGETHER, the files of each folder of the library, the command and each test program are compiled together, up
# to sixteen at a time: their headers are read once, and the whole takes a third of the time. Without it each file is compiled by
# itself, so that a missing include is found.
#
# So a name in an unnamed namespace must be the only one in its folder. Files that define macros are compiled by themselves: the
# kernels, for example. So are those with the property SKIP_UNITY_BUILD_INCLUSION.

# glint_group_sources(TARGET): after all sources have been added.
function(glint_group_sources target)
  if(NOT GLINT_FILES_TOGETHER)
    return()
  endif()
  # Files see one another's names, so a local may have the name of something in another file.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP
    UNITY_BUILD_CODE_BEFORE_INCLUDE "#pragma GCC diagnostic ignored \"-Wshadow\"")
  get_target_property(directory ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(folders)
  foreach(source ${sources})
    get_property(is_alone SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY SKIP_UNITY_BUILD_INCLUSION)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${directory} OUTPUT_VARIABLE path)
    if(is_alone OR NOT path MATCHES "[.]cpp$")
      continue()
    endif()
    file(STRINGS ${path} macros REGEX "^#define")
    if(macros)
      continue()
    endif()
    cmake_path(GET path PARENT_PATH path)
    file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${path})
    string(REPLACE / _ folder ${path})
    list(APPEND folders ${folder})
    list(APPEND files_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder ${folders})
    list(LENGTH files_${folder} count)
    math(EXPR groups "(${count} + 15) / 16")
    set(i 0)
    foreach(source ${files_${folder}})
      math(EXPR group "${i} * ${groups} / ${count}")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder}_${group})
      math(EXPR i "${i} + 1")
    endforeach()
  endforeach()
endfunction()
