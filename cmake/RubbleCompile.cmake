# How every target of this project is compiled. Results must be the same bits everywhere,
# so contraction to FMA is off and fast-math never on. rubble_language is for the one program that is never sanitised.
add_library(rubble_language INTERFACE)
add_library(rubble_compile INTERFACE)
target_link_libraries(rubble_compile INTERFACE rubble_language)
target_include_directories(rubble_language INTERFACE
  ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(rubble_language INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual $<$<BOOL:${RUBBLE_WERROR}>:-Werror> -ffp-contract=off
  # Structs are made with designated initialisers; what they leave out has its default.
  -Wno-missing-field-initializers)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # The compiler collects its garbage above 512 MiB only, which saves a tenth of its time: each collection visits all of
  # a precompiled header.
  target_compile_options(rubble_language INTERFACE "SHELL:--param ggc-min-heapsize=524288")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND RUBBLE_UNITY)
  # Types in anonymous namespaces of sources, which the compiler takes for headers.
  target_compile_options(rubble_language INTERFACE -Wno-subobject-linkage)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms on joining literals and strings: GCC bugs 105329 and 105651.
  target_compile_options(rubble_language INTERFACE
    -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # a | b of two truths saves a branch that cannot be predicted.
  target_compile_options(rubble_language INTERFACE -Wno-bitwise-instead-of-logical)
endif()
target_compile_definitions(rubble_language INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_EXPLICIT_CTOR)
if(RUBBLE_ASSERTS)
  target_compile_definitions(rubble_language INTERFACE RUBBLE_ASSERTS=1)
endif()
if(RUBBLE_SANITIZE)
  target_compile_options(rubble_compile INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(rubble_compile INTERFACE -fsanitize=address,undefined)
  set(RUBBLE_LEAKS "LSAN_OPTIONS=set:suppressions=${PROJECT_SOURCE_DIR}/tests/leaks.txt:print_suppressions=0")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # False alarms in std::variant and std::pair where code is instrumented: GCC's manual warns of them.
    target_compile_options(rubble_compile INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
if(RUBBLE_SANITIZE_THREADS)
  # A fence in the standard library, which ThreadSanitizer does not know.
  target_compile_options(rubble_compile INTERFACE -fsanitize=thread -fno-omit-frame-pointer -Wno-tsan)
  target_link_options(rubble_compile INTERFACE -fsanitize=thread)
endif()
# Where the programs and the tests take their memory from: docs/adr/0023. Not the importer, whose address space is
# limited, nor tests that replace the allocator themselves. Sanitizers only know the system's. To be linked by
# programs directly, since what an object library consists of is passed on to no other.
if(RUBBLE_SANITIZE OR RUBBLE_SANITIZE_THREADS)
  add_library(rubble_allocator INTERFACE)
else()
  find_package(mimalloc REQUIRED)
  add_library(rubble_allocator OBJECT ${PROJECT_SOURCE_DIR}/app/allocator/OperatorNew.cpp)
  set_target_properties(rubble_allocator PROPERTIES AUTOMOC OFF)
  target_link_libraries(rubble_allocator PUBLIC mimalloc PRIVATE rubble_compile INTERFACE rubble_core_base)
endif()
# For programs that load graphics drivers.
add_library(rubble_kept_libraries INTERFACE)
if(RUBBLE_SANITIZE)
  target_sources(rubble_kept_libraries INTERFACE ${PROJECT_SOURCE_DIR}/tests/support/KeptLibraries.cpp)
endif()
if(RUBBLE_COVERAGE)
  target_compile_options(rubble_compile INTERFACE --coverage)
  target_link_options(rubble_compile INTERFACE --coverage)
endif()
if(RUBBLE_FUZZ)
  target_compile_options(rubble_compile INTERFACE -fsanitize=fuzzer-no-link)
endif()
