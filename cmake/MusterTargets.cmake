# One static library per module; the order of dependencies is the order of the storeys.
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(PROJECT_IS_TOP_LEVEL)
    find_program(MUSTER_CCACHE ccache)
    if(MUSTER_CCACHE)
        set(CMAKE_CXX_COMPILER_LAUNCHER ${MUSTER_CCACHE})
    endif()
endif()

find_package(Threads REQUIRED)

# Flags that keep every build bit-identical, and warnings.
add_library(muster_flags INTERFACE)
target_compile_features(muster_flags INTERFACE cxx_std_20)
if(MSVC)
    # /fp:precise contracts nothing. Nobody has compared the bits of such a build yet.
    target_compile_options(muster_flags INTERFACE /fp:precise /utf-8 /EHsc /permissive-)
    target_compile_definitions(muster_flags INTERFACE NOMINMAX _CRT_SECURE_NO_WARNINGS)
else()
    target_compile_options(muster_flags INTERFACE -ffp-contract=off)
endif()
# For browsers: functions are inlined across files, because a point that is passed to a function goes through memory there;
# numbers become indices and memory is copied by single instructions, which all browsers have had since 2021.
if(EMSCRIPTEN)
    target_compile_options(muster_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:-flto> -mnontrapping-fptoint -mbulk-memory -msign-ext)
    # Threads share the module's memory, which only isolated pages allow: such a module is another one.
    if(MUSTER_WASM_THREADS)
        target_compile_options(muster_flags INTERFACE -pthread)
    endif()
endif()
# g++ 12 joins multiplications and alternating additions of neighbouring numbers to one rounding (vfmaddsub) whatever
# -ffp-contract says, where the processor can: so it is told that this one cannot.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "-m(arch|fma|avx)"
   AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(muster_flags INTERFACE -mno-fma -mno-fma4 -mno-avx512f)
endif()
# g++ 12 joins the two numbers of a point to one load right after it stored them one by one, and waits for the stores: a
# sixth of a step's time, without any gain.
target_compile_options(muster_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# Modules may end up in a shared library, but nobody replaces single functions of them: so they may be inlined.
target_compile_options(muster_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
target_compile_definitions(muster_flags INTERFACE EIGEN_DONT_VECTORIZE EIGEN_MPL2_ONLY)
add_library(muster_warnings INTERFACE)
if(MSVC)
    target_compile_options(muster_warnings INTERFACE /W3)
else()
    target_compile_options(muster_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
    # Sources that are compiled together are headers to g++, which does not expect anonymous namespaces there.
    target_compile_options(muster_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()

if(MUSTER_SANITIZE)
    add_compile_options(-fsanitize=${MUSTER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${MUSTER_SANITIZE})
    add_compile_definitions(MUSTER_ASSERTIONS=1)
endif()

# Third-party headers (Eigen, nlohmann-json) come from the system, or from MUSTER_DEPS_INCLUDE when cross-compiling.
set(MUSTER_DEPS_INCLUDE "" CACHE PATH "Folder with the Eigen and nlohmann headers when the system's cannot be used")
add_library(muster_eigen INTERFACE)
if(MUSTER_DEPS_INCLUDE)
    target_include_directories(muster_eigen SYSTEM INTERFACE ${MUSTER_DEPS_INCLUDE} ${MUSTER_DEPS_INCLUDE}/eigen3)
else()
    find_path(MUSTER_EIGEN_INCLUDE Eigen/SparseCholesky PATH_SUFFIXES eigen3 REQUIRED)
    target_include_directories(muster_eigen SYSTEM INTERFACE ${MUSTER_EIGEN_INCLUDE})
endif()

set(MUSTER_MODULES "" CACHE INTERNAL "")
set(MUSTER_KNOWN_COMPONENTS "" CACHE INTERNAL "")
set(MUSTER_BUILT_COMPONENTS "" CACHE INTERNAL "")

# muster_component(name [NEEDS component...]): the modules that follow are parts of it. They are built where MUSTER_COMPONENTS
# names it.
function(muster_component name)
    cmake_parse_arguments(COMPONENT "" "" "NEEDS" ${ARGN})
    set(MUSTER_COMPONENT ${name} PARENT_SCOPE)
    set(MUSTER_KNOWN_COMPONENTS ${MUSTER_KNOWN_COMPONENTS} ${name} CACHE INTERNAL "")
    set(MUSTER_NEEDS_${name} "${COMPONENT_NEEDS}" CACHE INTERNAL "")
    set(MUSTER_MODULES_${name} "" CACHE INTERNAL "")
    if(NOT name IN_LIST MUSTER_COMPONENTS)
        return()
    endif()
    foreach(needed ${COMPONENT_NEEDS})
        if(NOT needed IN_LIST MUSTER_COMPONENTS)
            message(FATAL_ERROR "component ${name} needs ${needed}, which MUSTER_COMPONENTS does not name")
        endif()
    endforeach()
    set(MUSTER_BUILT_COMPONENTS ${MUSTER_BUILT_COMPONENTS} ${name} CACHE INTERNAL "")
endfunction()

# muster_headers(name folder header...): what those that use the module may include. Its folder and its installed headers
# are linked into a folder of their own, build/headers/<name>, so that nobody finds headers of modules that they do not use.
function(muster_headers name folder)
    set(inside ${PROJECT_BINARY_DIR}/headers/${name}/inside)
    set(outside ${PROJECT_BINARY_DIR}/headers/${name}/outside)
    if(CMAKE_HOST_WIN32)
        return()  # Links need rights there: muster_module() gives the whole folders instead.
    endif()
    file(REMOVE_RECURSE ${inside} ${outside})
    get_filename_component(place ${folder} NAME)
    get_filename_component(parent ${folder} DIRECTORY)
    file(RELATIVE_PATH path ${MUSTER_FOLDER_ROOT} ${parent})
    file(MAKE_DIRECTORY ${inside}/${path} ${outside}/muster)
    file(CREATE_LINK ${folder} ${inside}/${path}/${place} SYMBOLIC)
    foreach(header ${ARGN})
        get_filename_component(below ${header} DIRECTORY)
        file(MAKE_DIRECTORY ${outside}/muster/${below})
        file(CREATE_LINK ${PROJECT_SOURCE_DIR}/include/muster/${header}.h ${outside}/muster/${header}.h SYMBOLIC)
    endforeach()
endfunction()

# Headers of the standard library, compiled once for all targets that are optimised alike. Each source includes what it needs
# all the same.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")
    # ccache looks at what uses a precompiled header only if it is told that it may.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# muster_precompiled(kind): the library whose precompiled header targets of that kind use.
function(muster_precompiled kind)
    add_library(muster_precompiled_${kind} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    set_target_properties(muster_precompiled_${kind} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(muster_precompiled_${kind} PRIVATE muster_flags muster_warnings)
    target_precompile_headers(muster_precompiled_${kind} PRIVATE <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory>
        <optional> <span> <string> <utility> <variant> <vector>)
endfunction()

# muster_compile_quickly(target [LIGHTLY]): compiles a library of Muster's in little time. LIGHTLY: it is optimised little,
# because no step runs in it.
function(muster_compile_quickly target)
    cmake_parse_arguments(COMPILE "LIGHTLY" "" "" ${ARGN})
    muster_compile_together(${target})
    set(kind full)
    if(COMPILE_LIGHTLY AND NOT EMSCRIPTEN AND NOT MSVC)
        set(kind light)
        muster_optimise_lightly(${target})
    endif()
    if(NOT MUSTER_PRECOMPILE OR EMSCRIPTEN OR MSVC)
        return()
    endif()
    if(NOT TARGET muster_precompiled_${kind})
        muster_precompiled(${kind})
        if(kind STREQUAL "light")
            muster_optimise_lightly(muster_precompiled_light)
        endif()
    endif()
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_precompile_headers(${target} REUSE_FROM muster_precompiled_${kind})
endfunction()

# muster_optimise_lightly(target): with -O2, since no step runs in it.
function(muster_optimise_lightly target)
    # g++ 12 warns of strings that it has half inlined.
    target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O2> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

# muster_compile_together(target): compiles the sources of this target many at a time (a unity build), which takes a third of
# the time: most of what a source includes is the same in all of them. Whoever edits one source often configures with
# MUSTER_COMPILE_TOGETHER=OFF (the preset dev).
function(muster_compile_together target)
    if(MUSTER_COMPILE_TOGETHER AND NOT CMAKE_UNITY_BUILD)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
    endif()
endfunction()

# muster_module(path [HEADERS installed...] [USES module...]): builds src/<path> and what lies below it, or <path> where that is a
# folder of bindings/. Its name is the last part of the path; HEADERS are those of include/muster that it implements. No module
# lies in the folder of another.
function(muster_module path)
    cmake_parse_arguments(MODULE "LIGHTLY" "" "HEADERS;USES" ${ARGN})
    get_filename_component(name ${path} NAME)
    if(NOT MUSTER_COMPONENT IN_LIST MUSTER_COMPONENTS)
        return()
    endif()
    set(MUSTER_FOLDER_ROOT ${PROJECT_SOURCE_DIR}/src)
    if(path MATCHES "^bindings/")
        set(MUSTER_FOLDER_ROOT ${PROJECT_SOURCE_DIR})
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${MUSTER_FOLDER_ROOT}/${path}/*.cpp)
    muster_headers(${name} ${MUSTER_FOLDER_ROOT}/${path} ${MODULE_HEADERS})

    set(inside ${PROJECT_BINARY_DIR}/headers/${name}/inside)
    set(outside ${PROJECT_BINARY_DIR}/headers/${name}/outside)
    if(CMAKE_HOST_WIN32)
        set(inside ${MUSTER_FOLDER_ROOT})
        set(outside ${PROJECT_SOURCE_DIR}/include)
    endif()

    # For Muster's own code: all headers of the module, and of those that it uses.
    add_library(muster_${name}_inside INTERFACE)
    target_include_directories(muster_${name}_inside INTERFACE ${inside} ${outside})

    # For everybody: its installed headers.
    add_library(muster_${name} STATIC ${sources})
    set(outer ${name})
    if(name IN_LIST MUSTER_KNOWN_COMPONENTS)
        set(outer ${name}_module)  # The plain name is the component's.
    endif()
    add_library(muster::${outer} ALIAS muster_${name})
    set_target_properties(muster_${name} PROPERTIES EXPORT_NAME ${outer} POSITION_INDEPENDENT_CODE ON)
    target_include_directories(muster_${name} PUBLIC $<BUILD_INTERFACE:${outside}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(muster_${name} PUBLIC cxx_std_20)
    target_link_libraries(muster_${name} PRIVATE $<BUILD_INTERFACE:muster_${name}_inside>
        $<BUILD_INTERFACE:muster_flags> $<BUILD_INTERFACE:muster_warnings> $<BUILD_INTERFACE:muster_eigen>)
    set(lightly "")
    if(MODULE_LIGHTLY)
        set(lightly LIGHTLY)
    endif()
    muster_compile_quickly(muster_${name} ${lightly})
    foreach(used ${MODULE_USES})
        if(NOT TARGET muster_${used})
            message(FATAL_ERROR "module ${path} uses ${used}, which is not built before it")
        endif()
        target_link_libraries(muster_${name}_inside INTERFACE muster_${used}_inside)
        target_link_libraries(muster_${name} PUBLIC muster_${used})
    endforeach()
    if(name STREQUAL "base")
        target_link_libraries(muster_${name} PUBLIC Threads::Threads)
    endif()
    set(MUSTER_MODULES ${MUSTER_MODULES} ${name} CACHE INTERNAL "")
    set(MUSTER_MODULES_${MUSTER_COMPONENT} ${MUSTER_MODULES_${MUSTER_COMPONENT}} ${name} CACHE INTERNAL "")
endfunction()

# muster_compile_small(target...): for browsers, code in which a step spends little of its time is made small: it is loaded
# over the wire.
function(muster_compile_small)
    if(NOT EMSCRIPTEN)
        return()
    endif()
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-Oz>)
    endforeach()
endfunction()

# muster_node_program(target): a WebAssembly program that Node runs, in one file: emscripten 3.1.6 would fetch() a second one,
# which newer Node refuses for paths.
function(muster_node_program target)
    target_link_options(${target} PRIVATE -sSINGLE_FILE=1 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1 -sEXIT_RUNTIME=1
        -sTOTAL_STACK=1048576 -sENVIRONMENT=node)
endfunction()

# muster_uses_header(module header): a header-only library that the module needs when it is compiled, from wherever CMake finds it.
function(muster_uses_header module header)
    if(NOT TARGET muster_${module} OR MUSTER_DEPS_INCLUDE)
        return()
    endif()
    string(MAKE_C_IDENTIFIER "MUSTER_INCLUDE_${header}" place)
    find_path(${place} ${header} REQUIRED)
    mark_as_advanced(${place})
    target_include_directories(muster_${module} SYSTEM PRIVATE $<BUILD_INTERFACE:${${place}}>)
endfunction()

# muster_compile_fast(source...): optimises these sources little in builds that optimise. For large template libraries in code
# that takes no time to run; in the folder of the target that compiles them.
function(muster_compile_fast)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS
        "$<$<NOT:$<CONFIG:Debug>>:-O1>;$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>")
endfunction()
