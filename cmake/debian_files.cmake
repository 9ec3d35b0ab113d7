# SPDX-License-Identifier: Apache-2.0
# What Debian's policy asks of a package and other installations have not: run by cpack on the folders of the components, before
# it packs them. Manual pages and changelogs are compressed, zsh's completions are where Debian's zsh looks, and the Python
# package has its metadata, by which pip and importlib.metadata know it.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share)
  set(doc ${share}/doc/${name})

  # The sources may have other permissions.
  configure_file(${CPACK_GLINT_SOURCE}/cmake/debian/copyright ${doc}/copyright COPYONLY NO_SOURCE_PERMISSIONS)
  configure_file(${CPACK_GLINT_SOURCE}/CHANGELOG.md ${doc}/changelog COPYONLY NO_SOURCE_PERMISSIONS)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, if that is set
  file(WRITE ${doc}/changelog.Debian
    "glint (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}: changelog.gz has what is new.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  file(GLOB manuals ${share}/man/man1/*.1)
  execute_process(COMMAND gzip -9nf ${doc}/changelog ${doc}/changelog.Debian ${manuals} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CPACK_GLINT_SOURCE}/tools/copy-licences ${component} ${doc}/libraries COMMAND_ERROR_IS_FATAL ANY)

  if(EXISTS ${share}/zsh/site-functions)
    file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
  endif()
  if(component STREQUAL python)
    execute_process(WORKING_DIRECTORY ${CPACK_GLINT_SOURCE}/python COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
      COMMAND /usr/bin/python3 setup.py -q dist_info --output-dir ${share}/../lib/python3/dist-packages)
  endif()
endforeach()
