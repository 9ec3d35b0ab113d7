# SPDX-License-Identifier: Apache-2.0
# Packages made by cpack: the Debian packages glint (the command, its documents and scenes), libglint-dev (headers and a
# static library), glint-mpi if an MPI was found, and python3-glint with GLINT_PYTHON. tools/make-release calls it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME glint)
set(CPACK_PACKAGE_VENDOR "The glint authors")
set(CPACK_PACKAGE_CONTACT "The glint authors <maintainers@glint.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Deterministic Phong and Blinn-Phong ray tracer for learning and teaching")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL command development)
if(TARGET glint_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()
if(GLINT_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME glint)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION
  "It renders scenes of spheres, planes, triangles and other simple shapes,\nexplains every pixel, and names the mistake in a wrong picture.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libglint-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SOURCE glint)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(JOIN GLINT_DEBIAN_DEPENDS ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "The library of the ray tracer glint: headers, a static library, and its\npackages for CMake and pkg-config.")

set(CPACK_DEBIAN_MPI_PACKAGE_NAME glint-mpi)
set(CPACK_DEBIAN_MPI_PACKAGE_SOURCE glint)
set(CPACK_DEBIAN_MPI_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS openmpi-bin)
set(CPACK_COMPONENT_MPI_DESCRIPTION
  "The ray tracer glint on many processes: glint-mpi renders one picture on all\nprocesses of an MPI job.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-glint)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SOURCE glint)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${GLINT_PYTHON_DEPENDS}")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "The Python package of the ray tracer glint: scenes, NumPy arrays, pictures,\nand the explanation of every pixel.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_GLINT_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake)
include(CPack)
