include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Suture)
install(EXPORT SutureTargets NAMESPACE suture:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SutureConfig.cmake.in SutureConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(SutureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/occt_versions.cmake
              ${PROJECT_BINARY_DIR}/SutureConfig.cmake
              ${PROJECT_BINARY_DIR}/SutureConfigVersion.cmake DESTINATION ${package_dir})
