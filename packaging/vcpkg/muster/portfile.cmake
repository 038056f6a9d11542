# A port to be used with --overlay-ports: it builds the tree that it lies in, or the one that MUSTER_SOURCE names.
if(DEFINED ENV{MUSTER_SOURCE})
    set(SOURCE_PATH "$ENV{MUSTER_SOURCE}")
else()
    get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
endif()
if(NOT EXISTS "${SOURCE_PATH}/include/muster/muster.h")
    message(FATAL_ERROR "${SOURCE_PATH}: found no include/muster/muster.h, expected Muster's sources (set MUSTER_SOURCE)")
endif()

set(components core)
foreach(component motion io)
    if(component IN_LIST FEATURES)
        list(APPEND components ${component})
    endif()
endforeach()
vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options FEATURES
    jupedsim MUSTER_WITH_SQLITE
    host-allocator MUSTER_HOST_ALLOCATOR)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "dynamic" shared)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" "static" archive)

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS
    "-DMUSTER_COMPONENTS=${components}"
    -DMUSTER_BUILD_SHARED=${shared}
    -DMUSTER_BUILD_ARCHIVE=${archive}
    -DMUSTER_BUILD_APPS=OFF
    -DMUSTER_BUILD_TESTS=OFF
    -DMUSTER_BUILD_HASHES=OFF
    -DMUSTER_BUILD_SCALE=OFF
    ${feature_options})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME muster CONFIG_PATH lib/cmake/muster)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
