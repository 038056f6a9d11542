# cmake --install, and find_package(muster) for those who link the library.
include(CMakePackageConfigHelpers)

add_library(muster INTERFACE)
add_library(muster::muster ALIAS muster)
set(installed muster)
foreach(module ${MUSTER_MODULES})
    target_link_libraries(muster INTERFACE muster_${module})
    list(APPEND installed muster_${module})
endforeach()

install(TARGETS ${installed} EXPORT musterTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/muster DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT musterTargets NAMESPACE muster:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/muster)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/musterConfig.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/musterConfig.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/muster)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/musterConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/musterConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/musterConfigVersion.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/muster)
if(TARGET muster_program)
    install(TARGETS muster_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/muster)
    # The page, where it is built: npm run build in web/, or ./run --build.
    install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/muster/web OPTIONAL)
    # The engine for browsers, where it is built: ./run -- site, or scripts/wasm.sh.
    install(DIRECTORY build/wasm/apps/engine/ DESTINATION ${CMAKE_INSTALL_DATADIR}/muster/engine OPTIONAL
        FILES_MATCHING PATTERN "muster-*.js" PATTERN "muster-*.wasm" PATTERN "CMakeFiles" EXCLUDE)
endif()
