# How everything of ours is compiled: one interface target that all our targets use.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE)
    # Copies of the project share what they compile: paths count from the build folder.
    set(launcher env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=yes ${CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()
find_program(MOLD mold)
if(MOLD)
    add_link_options(-fuse-ld=mold)
endif()

# lancer_define_places(NAME=PATH...  IN source...): macros for paths of this machine, in those sources that use them: all others compile to
# the same everywhere.
function(lancer_define_places)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "IN")
    foreach(source IN LISTS arg_IN)
        foreach(place IN LISTS arg_UNPARSED_ARGUMENTS)
            string(REGEX REPLACE "^([A-Z_]+)=(.*)$" "\\1=\"\\2\"" definition "${place}")
            file(STRINGS ${source} uses REGEX ${CMAKE_MATCH_1} LIMIT_COUNT 1)
            if(uses)
                set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS "${definition}")
            endif()
        endforeach()
    endforeach()
endfunction()

option(LANCER_WERROR "Treat warnings as errors" OFF)
set(LANCER_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize=")

add_library(lancer_compile INTERFACE)
target_compile_options(lancer_compile INTERFACE
    -Wall -Wextra -Wshadow -Wdouble-promotion -Wsign-conversion -Wfloat-conversion -Wnon-virtual-dtor -Woverloaded-virtual
    # The same bits everywhere: no fused multiply-add that the source does not spell.
    -ffp-contract=off
    # Neither changes a result: sqrt does not set errno, and nobody reads the floating-point exception flags.
    -fno-math-errno -fno-trapping-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    set(LANCER_X86_64 ON)
    # What every x86-64 machine since 2009 runs. Sources with a variant for each instruction set choose for themselves.
    target_compile_options(lancer_compile INTERFACE $<$<NOT:$<BOOL:$<TARGET_PROPERTY:LANCER_ISA>>>:-march=x86-64-v2>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(lancer_compile INTERFACE -Wno-restrict)  # wrong about joined std::strings, GCC bug 105651
endif()
if(LANCER_WERROR)
    target_compile_options(lancer_compile INTERFACE -Werror)
endif()
if(LANCER_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
        message(FATAL_ERROR "LANCER_FUZZ needs clang: libFuzzer is a part of it (use the preset fuzz)")
    endif()
    add_compile_options(-fsanitize=fuzzer-no-link)
    set(LANCER_SANITIZE "address,undefined")
endif()
if(LANCER_SANITIZE)
    add_compile_options(-fsanitize=${LANCER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${LANCER_SANITIZE})
endif()
