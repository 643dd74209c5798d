# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/csgcast)

install(TARGETS csgcast EXPORT csgcastTargets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT csgcastTargets NAMESPACE csgcast:: DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/include/csgcast DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET csgcast-tool)
    install(TARGETS csgcast-tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(FILES ${PROJECT_SOURCE_DIR}/docs/csgcast.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/examples
    DESTINATION ${CMAKE_INSTALL_DATADIR}/csgcast)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/csgcastConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/csgcastConfig.cmake.in
    ${PROJECT_BINARY_DIR}/csgcastConfig.cmake INSTALL_DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/csgcastConfig.cmake
    ${PROJECT_BINARY_DIR}/csgcastConfigVersion.cmake DESTINATION ${package_dir})

# pkg-config: relative to the file itself, so that `cmake --install --prefix` keeps it right.
file(RELATIVE_PATH prefix_from_pcfiledir ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
    ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pcfiledir "${prefix_from_pcfiledir}")
set(pc_libs "-L\${libdir} -lcsgcast")
set(pc_libs_private "-lpng -lz -lm -ldl -lpthread")
if(qhull_library)
    string(PREPEND pc_libs_private "-lqhull_r ")
endif()
if(NOT BUILD_SHARED_LIBS)
    set(pc_libs "${pc_libs} ${pc_libs_private}")
    set(pc_libs_private "")
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/csgcast.pc.in ${PROJECT_BINARY_DIR}/csgcast.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/csgcast.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Programs find a library in /usr/local/lib only after ldconfig. Left alone for a package's DESTDIR
# and for other prefixes; without root it fails, and that is fine.
install(CODE [[
    if("$ENV{DESTDIR}" STREQUAL "" AND CMAKE_INSTALL_PREFIX MATCHES "^/usr(/local)?/?$")
        execute_process(COMMAND /sbin/ldconfig OUTPUT_QUIET ERROR_QUIET)
    endif()
]])
