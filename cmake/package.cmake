# make install: the library, its headers, the CMake package (find_package(glint)) and pkg-config's glint.pc.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set_target_properties(glint PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
target_compile_features(glint PUBLIC cxx_std_20)

install(TARGETS glint EXPORT glint-targets)
install(DIRECTORY include/glint TYPE INCLUDE)
install(FILES LICENSE NOTICE TYPE DOC)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/glint)
install(EXPORT glint-targets NAMESPACE glint:: DESTINATION ${package})
# Who links a static library links what it uses, too; a shared one has done so.
get_target_property(type glint TYPE)
string(COMPARE EQUAL "${type}" STATIC_LIBRARY GLINT_IS_STATIC)
configure_package_config_file(cmake/glint-config.cmake.in ${PROJECT_BINARY_DIR}/package/glint-config.cmake
  INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/glint-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/glint-config.cmake ${PROJECT_BINARY_DIR}/package/glint-config-version.cmake
  DESTINATION ${package})

# Relative to the file itself, so that an installed tree may be moved.
cmake_path(SET pkgconfig_dir NORMALIZE ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pc ${pkgconfig_dir} ${CMAKE_INSTALL_PREFIX})
if(GLINT_IS_STATIC)
  set(pc_requires Requires)
else()
  set(pc_requires Requires.private)
endif()
configure_file(cmake/glint.pc.in ${PROJECT_BINARY_DIR}/package/glint.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/glint.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
