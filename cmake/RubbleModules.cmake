# A module is one library in one folder. It names the modules it may use; that list links it and is also what the build
# checks every #include against. Its parts are sub-folders, each of which may use those named before it. Main.cpp
# belongs to a program.

# rubble_module(<folder> PARTS <sub-folder>... USES <folder>... LINKS <target>... PRIVATE <target>... PRECOMPILED
# <header>)
#   PARTS        sub-folders from the lowest to the highest; "." for the folder itself, which may only be the highest
#   USES         modules whose headers this one may include (transitively)
#   LINKS        third-party targets that appear in the module's headers
#   PRIVATE      third-party targets used in its .cpp files only
#   PRECOMPILED  what most of its sources include, a header in cmake/precompiled; none by default
function(rubble_module folder)
  cmake_parse_arguments(MODULE "" "PRECOMPILED" "PARTS;USES;LINKS;PRIVATE" ${ARGN})
  rubble_module_target(${folder} target)
  set(patterns ${folder}/*.cpp ${folder}/*.h)
  foreach(part IN LISTS MODULE_PARTS)
    if(NOT part STREQUAL ".")
      list(APPEND patterns ${folder}/${part}/*.cpp ${folder}/${part}/*.h)
    endif()
  endforeach()
  list(TRANSFORM patterns PREPEND ${PROJECT_SOURCE_DIR}/)
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources EXCLUDE REGEX "/Main\\.cpp$")
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC rubble_compile ${MODULE_LINKS} PRIVATE ${MODULE_PRIVATE})

  set(below "")
  foreach(used IN LISTS MODULE_USES)
    rubble_module_target(${used} used_target)
    target_link_libraries(${target} PUBLIC ${used_target})
    get_property(used_folders GLOBAL PROPERTY RUBBLE_FOLDERS_${used_target})
    list(APPEND below ${used_folders})
  endforeach()
  if(MODULE_PRECOMPILED)
    rubble_precompile(${target} ${MODULE_PRECOMPILED})
  endif()
  rubble_declare_dependencies(${folder} PARTS ${MODULE_PARTS} USES ${below})
endfunction()

# rubble_declare_dependencies(<folder> PARTS <sub-folder>... USES <folder>...): what the sources in a folder may
# include. The folders in USES are those of the parts, too. For programs, which are no modules.
function(rubble_declare_dependencies folder)
  cmake_parse_arguments(MODULE "" "" "PARTS;USES" ${ARGN})
  set(folders ${MODULE_USES})
  if(NOT MODULE_PARTS)
    set(MODULE_PARTS .)
  endif()
  foreach(part IN LISTS MODULE_PARTS)
    cmake_path(SET path NORMALIZE ${folder}/${part})
    string(REGEX REPLACE "/$" "" path ${path})
    list(APPEND folders ${path})
    list(REMOVE_DUPLICATES folders)
    list(JOIN folders " " words)
    set_property(GLOBAL APPEND PROPERTY RUBBLE_DEPENDENCIES "${path}: ${words}")
  endforeach()
  rubble_module_target(${folder} target)
  set_property(GLOBAL PROPERTY RUBBLE_FOLDERS_${target} "${folders}")
endfunction()

function(rubble_module_target folder result)
  string(REPLACE "/" "_" name ${folder})
  set(${result} rubble_${name} PARENT_SCOPE)
endfunction()

# rubble_precompile(<target> <header>): compiles a header of cmake/precompiled once for all targets that use it and link
# the same of the libraries below, whose definitions and options it depends on. Call after the target's libraries are
# declared.
function(rubble_precompile target header)
  rubble_linked(${target} linked)
  set(libraries "")
  foreach(library glm::glm nlohmann_json::nlohmann_json Qt6::Core Qt6::Gui Qt6::Widgets Qt6::Test)
    if(library IN_LIST linked)
      list(APPEND libraries ${library})
    endif()
  endforeach()
  string(MAKE_C_IDENTIFIER "precompiled_${header}_${libraries}" owner)
  if(NOT TARGET ${owner})
    set(source ${PROJECT_BINARY_DIR}/generated/Precompiled.cpp)  # a target needs one
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${owner} OBJECT ${source})
    set_target_properties(${owner} PROPERTIES AUTOMOC OFF)
    target_link_libraries(${owner} PRIVATE rubble_compile ${libraries})
    target_precompile_headers(${owner} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${header})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()

# Sets `result` to the targets whose headers a target may include: those it links, and what these link publicly.
function(rubble_linked target result)
  get_target_property(open ${target} LINK_LIBRARIES)
  set(linked "")
  while(open)
    list(POP_FRONT open library)
    if(TARGET "${library}" AND NOT library IN_LIST linked)
      list(APPEND linked ${library})
      get_target_property(further ${library} INTERFACE_LINK_LIBRARIES)
      if(further)
        list(APPEND open ${further})
      endif()
    endif()
  endwhile()
  set(${result} ${linked} PARENT_SCOPE)
endfunction()

# Adds the target that fails the build where a source lies or includes what it must not.
function(rubble_check_dependencies)
  get_property(dependencies GLOBAL PROPERTY RUBBLE_DEPENDENCIES)
  list(JOIN dependencies "\n" lines)
  file(WRITE ${PROJECT_BINARY_DIR}/dependencies.txt.new "${lines}\n")
  configure_file(${PROJECT_BINARY_DIR}/dependencies.txt.new ${PROJECT_BINARY_DIR}/dependencies.txt COPYONLY)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/core/*.h ${PROJECT_SOURCE_DIR}/core/*.cpp
    ${PROJECT_SOURCE_DIR}/viewport/*.h ${PROJECT_SOURCE_DIR}/viewport/*.cpp
    ${PROJECT_SOURCE_DIR}/editor/*.h ${PROJECT_SOURCE_DIR}/editor/*.cpp
    ${PROJECT_SOURCE_DIR}/app/*.h ${PROJECT_SOURCE_DIR}/app/*.cpp)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/dependencies.ok
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DDEPENDENCIES=${PROJECT_BINARY_DIR}/dependencies.txt
            -P ${PROJECT_SOURCE_DIR}/cmake/CheckDependencies.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/dependencies.ok
    DEPENDS ${files} ${PROJECT_BINARY_DIR}/dependencies.txt ${PROJECT_SOURCE_DIR}/cmake/CheckDependencies.cmake
    COMMENT "Checking the dependencies between folders" VERBATIM)
  add_custom_target(dependencies ALL DEPENDS ${PROJECT_BINARY_DIR}/dependencies.ok)
endfunction()
