# What Debian's policy wants of every package: its copyright file and changelog. The sources of both are
# LICENSE's first words and CHANGELOG.md.
file(WRITE ${PROJECT_BINARY_DIR}/debian/copyright
     "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Suture

Files: *
Copyright: 2026 the Suture developers
License: LGPL-2.1+
 On Debian systems the text of the GNU Lesser General Public License 2.1 is in
 /usr/share/common-licenses/LGPL-2.1.
")
file(WRITE ${PROJECT_BINARY_DIR}/debian/changelog
     "suture (${PROJECT_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  Thu, 01 Jan 1970 00:00:00 +0000
")
find_program(SUTURE_GZIP gzip)
mark_as_advanced(SUTURE_GZIP)
if(SUTURE_GZIP)
    execute_process(COMMAND ${SUTURE_GZIP} -9nf ${PROJECT_BINARY_DIR}/debian/changelog)
    foreach(pair program=suture development=libsuture-dev workbench=freecad-suture)
        string(REPLACE "=" ";" pair ${pair})
        list(GET pair 0 component)
        list(GET pair 1 package)
        install(
            FILES ${PROJECT_BINARY_DIR}/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.gz
            DESTINATION share/doc/${package}
            COMPONENT ${component})
    endforeach()
endif()
