# A room is one library in one folder. It names the rooms it may use; that list links it and is
# also what the build checks every #include against. Main.cpp belongs to a program beside it.

# rubble_room(<folder> USES <folder>... LINKS <target>... PRIVATE <target>...)
#   USES     rooms whose headers this room may include (transitively)
#   LINKS    third-party targets that appear in the room's headers
#   PRIVATE  third-party targets used in its .cpp files only
function(rubble_room folder)
  cmake_parse_arguments(ROOM "" "" "USES;LINKS;PRIVATE" ${ARGN})
  rubble_room_target(${folder} target)
  file(GLOB sources CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/${folder}/*.cpp ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER sources EXCLUDE REGEX "/Main\\.cpp$")
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC rubble_compile ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE})
  set(allowed ${folder})
  foreach(used IN LISTS ROOM_USES)
    rubble_room_target(${used} used_target)
    target_link_libraries(${target} PUBLIC ${used_target})
    get_property(used_allowed GLOBAL PROPERTY RUBBLE_ALLOWED_${used_target})
    list(APPEND allowed ${used_allowed})
  endforeach()
  rubble_declare_arrows(${folder} ${allowed})
endfunction()

# rubble_declare_arrows(<folder> <allowed folder>...): for programs, which are no libraries.
function(rubble_declare_arrows folder)
  set(allowed ${folder} ${ARGN})
  list(REMOVE_DUPLICATES allowed)
  rubble_room_target(${folder} target)
  set_property(GLOBAL PROPERTY RUBBLE_ALLOWED_${target} "${allowed}")
  list(JOIN allowed " " words)
  set_property(GLOBAL APPEND PROPERTY RUBBLE_ARROWS "${folder}: ${words}")
endfunction()

function(rubble_room_target folder result)
  string(REPLACE "/" "_" name ${folder})
  set(${result} rubble_${name} PARENT_SCOPE)
endfunction()

# Adds the target that fails the build on an include against the arrows. Every room waits for it.
function(rubble_check_arrows)
  get_property(arrows GLOBAL PROPERTY RUBBLE_ARROWS)
  list(JOIN arrows "\n" lines)
  file(WRITE ${PROJECT_BINARY_DIR}/arrows.txt.new "${lines}\n")
  configure_file(${PROJECT_BINARY_DIR}/arrows.txt.new ${PROJECT_BINARY_DIR}/arrows.txt COPYONLY)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/core/*.h ${PROJECT_SOURCE_DIR}/core/*.cpp
    ${PROJECT_SOURCE_DIR}/viewport/*.h ${PROJECT_SOURCE_DIR}/viewport/*.cpp
    ${PROJECT_SOURCE_DIR}/editor/*.h ${PROJECT_SOURCE_DIR}/editor/*.cpp
    ${PROJECT_SOURCE_DIR}/app/*.h ${PROJECT_SOURCE_DIR}/app/*.cpp)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/arrows.ok
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DARROWS=${PROJECT_BINARY_DIR}/arrows.txt
            -P ${PROJECT_SOURCE_DIR}/cmake/CheckArrows.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/arrows.ok
    DEPENDS ${files} ${PROJECT_BINARY_DIR}/arrows.txt ${PROJECT_SOURCE_DIR}/cmake/CheckArrows.cmake
    COMMENT "Checking the arrows between the rooms" VERBATIM)
  add_custom_target(arrows ALL DEPENDS ${PROJECT_BINARY_DIR}/arrows.ok)
endfunction()
