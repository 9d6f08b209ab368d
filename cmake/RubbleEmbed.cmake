# Text files as part of a program, so that it finds them wherever it lies.

# rubble_embed(<folder> <name>): the files in a folder as the library <name>, whose header generated/<name>.h has
# std::string_view rubble::<name in lowerCamelCase>(std::string_view fileName), empty where there is no such file, and
# std::span<const std::string_view> rubble::<name in lowerCamelCase>Names(), what files there are, by name.
function(rubble_embed folder name)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*)
  string(REGEX REPLACE "_(.)" ";\\1" words ${name})
  set(function "")
  foreach(word IN LISTS words)
    if(function)
      string(SUBSTRING ${word} 0 1 first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND function ${first}${rest})
    else()
      set(function ${word})
    endif()
  endforeach()
  set(generated ${PROJECT_BINARY_DIR}/generated)
  add_custom_command(OUTPUT ${generated}/${name}.cpp ${generated}/${name}.h
    COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DNAME=${name} -DFUNCTION=${function} -DPLACE=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    COMMENT "Embedding ${name}" VERBATIM)
  add_library(${name} STATIC ${generated}/${name}.cpp ${generated}/${name}.h)
  target_link_libraries(${name} PUBLIC rubble_compile)
endfunction()
