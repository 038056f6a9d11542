# The library as one file, for programs in C and other languages: libmuster.so and libmuster.a, from the objects of the modules.
foreach(module c_world c_motion c_io)
    if(TARGET muster_${module})
        target_compile_definitions(muster_${module} PRIVATE MUSTER_BUILDING=1)
        set_target_properties(muster_${module} PROPERTIES CXX_VISIBILITY_PRESET hidden)
    endif()
endforeach()
if(TARGET muster_c_world)
    target_compile_definitions(muster_c_world PRIVATE MUSTER_VERSION="${PROJECT_VERSION}"
        $<$<TARGET_EXISTS:muster_c_motion>:MUSTER_WITH_MOTION=1> $<$<TARGET_EXISTS:muster_c_io>:MUSTER_WITH_IO=1>)
endif()

# One target for each component, for programs that link modules; muster is all of them.
add_library(muster INTERFACE)
add_library(muster::muster ALIAS muster)
foreach(component ${MUSTER_BUILT_COMPONENTS})
    add_library(muster_component_${component} INTERFACE)
    add_library(muster::${component} ALIAS muster_component_${component})
    set_target_properties(muster_component_${component} PROPERTIES EXPORT_NAME ${component})
    list(TRANSFORM MUSTER_NEEDS_${component} PREPEND muster_component_ OUTPUT_VARIABLE needed)
    list(TRANSFORM MUSTER_MODULES_${component} PREPEND muster_ OUTPUT_VARIABLE modules)
    target_link_libraries(muster_component_${component} INTERFACE ${needed} ${modules})
    target_link_libraries(muster INTERFACE muster_component_${component})
endforeach()

set(MUSTER_OBJECTS "")
foreach(component core motion io)
    foreach(module ${MUSTER_MODULES_${component}})
        list(APPEND MUSTER_OBJECTS $<TARGET_OBJECTS:muster_${module}>)
    endforeach()
endforeach()

# What libraries in one file share.
function(muster_whole_library target)
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# muster_shared_library(target): a shared library that shows the C API and nothing else. MSVC shows what is declared so, and
# no more.
function(muster_shared_library target)
    add_library(${target} SHARED ${MUSTER_OBJECTS})
    muster_whole_library(${target})
    target_compile_definitions(${target} INTERFACE MUSTER_SHARED=1)
    target_link_libraries(${target} PRIVATE Threads::Threads ${MUSTER_SQLITE_LIBRARY})
    if(APPLE)
        target_link_options(${target} PRIVATE "LINKER:-exported_symbol,_muster_*")
    elseif(UNIX)
        set(symbols ${PROJECT_SOURCE_DIR}/cmake/muster_symbols.map)
        target_link_options(${target} PRIVATE "LINKER:--version-script=${symbols}" "LINKER:--exclude-libs,ALL")
        set_target_properties(${target} PROPERTIES LINK_DEPENDS ${symbols})
    endif()
endfunction()

# muster_cover_engine(target): operators new and delete of the library's own, and of its own copy of the C++ library.
function(muster_cover_engine target)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/bindings/c/host_new.cpp)
    target_link_libraries(${target} PRIVATE muster_flags muster_warnings muster_c_world_inside)
    target_link_options(${target} PRIVATE -static-libstdc++ -static-libgcc)
endfunction()

# In browsers there are no shared libraries.
if(MUSTER_BUILD_SHARED AND NOT EMSCRIPTEN)
    muster_shared_library(muster_shared)
    add_library(muster::shared ALIAS muster_shared)
    set_target_properties(muster_shared PROPERTIES OUTPUT_NAME muster EXPORT_NAME shared VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(MUSTER_HOST_ALLOCATOR)
        muster_cover_engine(muster_shared)
    endif()
endif()
if(MUSTER_BUILD_ARCHIVE)
    add_library(muster_archive STATIC ${MUSTER_OBJECTS})
    add_library(muster::archive ALIAS muster_archive)
    muster_whole_library(muster_archive)
    set_target_properties(muster_archive PROPERTIES OUTPUT_NAME muster EXPORT_NAME archive)
    target_link_libraries(muster_archive INTERFACE Threads::Threads)
    if(MUSTER_SQLITE_LIBRARY)
        target_link_libraries(muster_archive INTERFACE $<BUILD_INTERFACE:${MUSTER_SQLITE_LIBRARY}>
            $<INSTALL_INTERFACE:SQLite::SQLite3>)
    endif()
    if(WIN32)
        set_target_properties(muster_archive PROPERTIES OUTPUT_NAME muster_static)  # muster.lib is that of muster.dll.
    endif()
endif()
