# find_package(hfdem) gives the target hfdem::hfdem.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS hfdem EXPORT hfdem-targets FILE_SET HEADERS)
install(EXPORT hfdem-targets NAMESPACE hfdem::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/hfdem)
configure_package_config_file(cmake/hfdem-config.cmake.in hfdem-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/hfdem)
write_basic_package_version_file(hfdem-config-version.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/hfdem-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/hfdem-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/hfdem)
