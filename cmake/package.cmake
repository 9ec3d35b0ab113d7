# SPDX-License-Identifier: Apache-2.0
# make install: the library, its headers, the CMake package (find_package(glint)) and pkg-config's glint.pc; the command with
# its documents and scenes. Components: library (a shared one), development, command.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS glint EXPORT glint-targets
  RUNTIME COMPONENT library
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(DIRECTORY include/glint TYPE INCLUDE COMPONENT development)
if(TARGET glint_command)
  # In the places that they have here, so that their links work. The scenes have a folder of their own, and a link to it.
  install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE NOTICE SECURITY.md TYPE DOC COMPONENT command)
  install(DIRECTORY docs TYPE DOC COMPONENT command)
  install(DIRECTORY examples TYPE DOC COMPONENT command)
  install(FILES src/wasm/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/src/wasm COMPONENT command)
  install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/glint COMPONENT command)
  file(RELATIVE_PATH scenes_from_docs ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_DATADIR}/glint/scenes)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
  file(CREATE_LINK ${scenes_from_docs} ${PROJECT_BINARY_DIR}/package/scenes SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/package/scenes TYPE DOC COMPONENT command)
else()
  install(FILES LICENSE NOTICE TYPE DOC COMPONENT development)
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/glint)
install(EXPORT glint-targets NAMESPACE glint:: DESTINATION ${package} COMPONENT development)
# Users of a static library link its dependencies, too; a shared library has linked them already.
get_target_property(type glint TYPE)
string(COMPARE EQUAL "${type}" STATIC_LIBRARY GLINT_IS_STATIC)
configure_package_config_file(cmake/glint-config.cmake.in ${PROJECT_BINARY_DIR}/package/glint-config.cmake
  INSTALL_DESTINATION ${package})
# The same rule as the SOVERSION in src/CMakeLists.txt: each minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/glint-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/glint-config.cmake ${PROJECT_BINARY_DIR}/package/glint-config-version.cmake
  DESTINATION ${package} COMPONENT development)

# Relative to the file itself, so that an installed tree can be moved.
cmake_path(SET pkgconfig_dir NORMALIZE ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_pc ${pkgconfig_dir} ${CMAKE_INSTALL_PREFIX})
list(JOIN GLINT_PC_REQUIRES " " pc_requires)
if(GLINT_IS_STATIC)
  set(pc_field Requires)
else()
  set(pc_field Requires.private)
endif()
configure_file(cmake/glint.pc.in ${PROJECT_BINARY_DIR}/package/glint.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/glint.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
