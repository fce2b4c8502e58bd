# What users get who do not build: made by the targets below, described in docs/ship.md.
find_program(SUTURE_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(SUTURE_PYTHON NAMES python3)
mark_as_advanced(SUTURE_PYTHON)
set(ship_name suture-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(ship_dir ${PROJECT_BINARY_DIR}/ship)
set(ship_scripts ${PROJECT_SOURCE_DIR}/cmake/ship)

install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(
    DIRECTORY docs/
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs
    COMPONENT program
    FILES_MATCHING
    PATTERN "*.md"
    PATTERN "*.schema.json"
    PATTERN figures EXCLUDE
    PATTERN examples EXCLUDE)

# Man pages and completions, made by the program from its command line's definitions.
set(described ${PROJECT_BINARY_DIR}/described)
add_custom_command(
    OUTPUT ${described}/stamp
    COMMAND ${ship_scripts}/describe.sh $<TARGET_FILE:suture> ${described}
    DEPENDS suture ${ship_scripts}/describe.sh
    COMMENT "Writing man pages and completions" VERBATIM)
add_custom_target(describe ALL DEPENDS ${described}/stamp)
# Not there before the target was built: who installs the program alone gets it without.
install(DIRECTORY ${described}/share/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program OPTIONAL)

if(SUTURE_PYTHON)
    add_custom_target(
        bundle_folder
        COMMAND ${SUTURE_PYTHON} -B ${ship_scripts}/bundle.py ${PROJECT_BINARY_DIR}
                ${ship_dir}/${ship_name}
        DEPENDS suture ${described}/stamp
        COMMENT "Gathering the program and its libraries" VERBATIM)
    add_custom_target(
        bundle
        COMMAND ${SUTURE_PYTHON} -B ${ship_scripts}/pack.py ${ship_dir}/${ship_name}
                ${ship_dir}/${ship_name}.tar.xz
        COMMENT "Packing the bundle" VERBATIM USES_TERMINAL)
    add_custom_target(
        wheel
        COMMAND ${SUTURE_PYTHON} -B ${ship_scripts}/wheel.py ${ship_dir}/${ship_name} ${ship_dir}/wheel
                ${ship_dir}
        COMMENT "Making the Python wheel" VERBATIM USES_TERMINAL)
    add_custom_target(
        source_archive
        COMMAND ${SUTURE_PYTHON} -B ${ship_scripts}/source.py ${PROJECT_BINARY_DIR}/step_io/report
                ${ship_dir}/suture-${PROJECT_VERSION}.tar.xz
        COMMENT "Packing the sources with the report's page" VERBATIM)
    add_dependencies(source_archive suture_report)
    add_dependencies(bundle bundle_folder)
    add_dependencies(wheel bundle_folder)
endif()

# Debian packages: cpack -G DEB --config build/release/CPackConfig.cmake
set(CPACK_PACKAGE_NAME suture)
file(READ ${PROJECT_SOURCE_DIR}/package.xml package_xml)
string(REGEX MATCH "<maintainer email=\"([^\"]+)\"" found "${package_xml}")
set(CPACK_PACKAGE_CONTACT "The Suture developers <${CMAKE_MATCH_1}>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "close the holes of CAD models with smooth faces")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_OUTPUT_FILE_PREFIX ${ship_dir})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development workbench)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(about "Reads STEP, IGES or BREP, finds where a face is missing, fills the gap
 so that it joins its neighbours in position, tangent or curvature, sews
 the new face in, and measures what came of it.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME suture)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libopenblas0-pthread)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${about}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsuture-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "suture (= ${PROJECT_VERSION}), libocct-data-exchange-dev, libocct-ocaf-dev, libfontconfig-dev, libeigen3-dev, libexpected-dev, libfmt-dev, libtbb-dev, nlohmann-json3-dev"
)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${about}\n This package has the C++ library.")
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_NAME freecad-suture)
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_WORKBENCH_PACKAGE_DEPENDS "suture (>= ${PROJECT_VERSION}), freecad")
set(CPACK_DEBIAN_WORKBENCH_DESCRIPTION "${about}\n This package has the workbench for FreeCAD.")
install(
    DIRECTORY plugin/
    DESTINATION share/freecad/Mod/Suture/plugin
    COMPONENT workbench
    PATTERN __pycache__ EXCLUDE)
install(FILES package.xml DESTINATION share/freecad/Mod/Suture COMPONENT workbench)
include(debian_docs)
include(CPack)
