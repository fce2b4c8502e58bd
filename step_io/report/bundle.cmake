# Bundles web/*.js and three.js into viewer.js and viewer.css.
set(web ${CMAKE_CURRENT_SOURCE_DIR}/web)
set(node ${CMAKE_CURRENT_BINARY_DIR}/node)
file(GLOB sources CONFIGURE_DEPENDS ${web}/*.js ${web}/*.css)
add_custom_command(
    OUTPUT ${node}/installed
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/install_node_packages.sh ${web} ${node}
    DEPENDS ${web}/package.json ${web}/package-lock.json
            ${PROJECT_SOURCE_DIR}/cmake/install_node_packages.sh
    COMMENT "Installing the npm packages of the report" VERBATIM)
add_custom_command(
    OUTPUT viewer.js viewer.css
    COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${node}/node_modules ${node}/node_modules/.bin/esbuild
            entry.js style.css --bundle --minify --format=iife --target=es2020 --charset=utf8
            --legal-comments=inline --log-level=warning --entry-names=../viewer
            --outdir=${CMAKE_CURRENT_BINARY_DIR}/esbuild
    DEPENDS ${sources} ${node}/installed
    WORKING_DIRECTORY ${web}
    COMMENT "Bundling the report's script" VERBATIM)
