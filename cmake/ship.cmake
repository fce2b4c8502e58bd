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

if(SUTURE_PYTHON)
    add_custom_target(
        bundle_folder
        COMMAND ${SUTURE_PYTHON} -B ${ship_scripts}/bundle.py ${PROJECT_BINARY_DIR}
                ${ship_dir}/${ship_name}
        DEPENDS suture
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
    add_dependencies(bundle bundle_folder)
    add_dependencies(wheel bundle_folder)
endif()
