# cmake --install, find_package(muster [COMPONENTS core motion io studio lab]), and pkg-config.
include(CMakePackageConfigHelpers)
set(MUSTER_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/muster)

# One file of targets per component, so that nobody needs what only other components need.
foreach(component ${MUSTER_BUILT_COMPONENTS})
    list(TRANSFORM MUSTER_MODULES_${component} PREPEND muster_ OUTPUT_VARIABLE modules)
    install(TARGETS muster_component_${component} ${modules} EXPORT muster_${component}_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT muster_${component}_targets NAMESPACE muster:: DESTINATION ${MUSTER_PACKAGE_FOLDER}
        FILE muster_${component}.cmake)
endforeach()
foreach(whole shared archive)
    if(TARGET muster_${whole})
        install(TARGETS muster_${whole} EXPORT muster_${whole}_targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
        install(EXPORT muster_${whole}_targets NAMESPACE muster:: DESTINATION ${MUSTER_PACKAGE_FOLDER}
            FILE muster_${whole}.cmake)
    endif()
endforeach()
install(DIRECTORY include/muster DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/musterConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/musterConfig.cmake
    INSTALL_DESTINATION ${MUSTER_PACKAGE_FOLDER})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/musterConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/musterConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/musterConfigVersion.cmake
    DESTINATION ${MUSTER_PACKAGE_FOLDER})

# pkg-config, where the library is one file.
if(MUSTER_BUILD_SHARED OR MUSTER_BUILD_ARCHIVE)
    set(MUSTER_PC_PRIVATE "-lm ${CMAKE_THREAD_LIBS_INIT}")
    if(APPLE)
        string(APPEND MUSTER_PC_PRIVATE " -lc++")
    else()
        string(APPEND MUSTER_PC_PRIVATE " -lstdc++")
    endif()
    set(MUSTER_PC_REQUIRES "")
    if(MUSTER_SQLITE_LIBRARY)
        set(MUSTER_PC_REQUIRES sqlite3)
    endif()
    configure_file(${CMAKE_CURRENT_LIST_DIR}/muster.pc.in ${CMAKE_CURRENT_BINARY_DIR}/muster.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/muster.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# What is installed, as one target.
add_custom_target(muster_everything)
foreach(target shared archive program lab)
    if(TARGET muster_${target})
        add_dependencies(muster_everything muster_${target})
    endif()
endforeach()
foreach(module ${MUSTER_MODULES})
    add_dependencies(muster_everything muster_${module})
endforeach()

if(TARGET muster_program)
    install(TARGETS muster_program muster_lab RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/muster)
    # The page, where it is built: npm run build in web/, or ./run --build.
    install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/muster/web OPTIONAL)
    # The engine for browsers, where it is built: ./run -- site, or scripts/wasm.sh.
    install(DIRECTORY build/wasm/apps/engine/ DESTINATION ${CMAKE_INSTALL_DATADIR}/muster/engine OPTIONAL
        FILES_MATCHING PATTERN "muster-*.js" PATTERN "muster-*.wasm" PATTERN "CMakeFiles" EXCLUDE)
endif()
