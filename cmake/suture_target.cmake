# suture_folder(NAME SOURCES file... HEADERS file... LINK target...)
# One folder of the flow as a static library suture_NAME, exported as suture::NAME. HEADERS are those
# that are installed: what <suture/suture.h> includes, and what these include (tests/package).
# OCC adds the precompiled header of OCCT's most used headers.
function(suture_folder name)
    cmake_parse_arguments(arg "OCC" "" "SOURCES;HEADERS;LINK" ${ARGN})
    if(arg_SOURCES)
        add_library(suture_${name} STATIC ${arg_SOURCES})
        set(scope PUBLIC)
        target_link_libraries(suture_${name} PRIVATE $<BUILD_INTERFACE:suture_flags>)
        set_target_properties(suture_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    else()
        add_library(suture_${name} INTERFACE)
        set(scope INTERFACE)
    endif()
    add_library(suture::${name} ALIAS suture_${name})
    set_target_properties(suture_${name} PROPERTIES EXPORT_NAME ${name})
    target_compile_features(suture_${name} ${scope} cxx_std_20)
    target_sources(
        suture_${name} ${scope} FILE_SET HEADERS BASE_DIRS ${SUTURE_INCLUDE_ROOT} FILES
                                ${arg_HEADERS})
    target_link_libraries(suture_${name} ${scope} ${arg_LINK})
    if(arg_OCC)
        suture_use_occt_header(suture_${name})
    endif()
    install(
        TARGETS suture_${name}
        EXPORT SutureTargets
        FILE_SET HEADERS DESTINATION ${SUTURE_INCLUDE_DESTINATION})
    set_property(GLOBAL APPEND PROPERTY SUTURE_TARGETS suture_${name}) # for tests/layering
endfunction()

# suture_module(NAME FOLDER SOURCES file... LINK library...)
# What few runs of a folder need, with libraries that take long to load: suture_NAME.so, which
# symbol_on_demand (kernel/suture/platform/on_demand.h) finds on the program's run path.
function(suture_module name folder)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    set(module suture_module_${name})
    add_library(${module} MODULE ${arg_SOURCES})
    set_target_properties(${module} PROPERTIES PREFIX "" OUTPUT_NAME suture_${name}
                                               LIBRARY_OUTPUT_DIRECTORY ${SUTURE_MODULE_DIR})
    target_include_directories(${module} PRIVATE ${SUTURE_INCLUDE_ROOT} ${PROJECT_SOURCE_DIR}/kernel)
    target_include_directories(${module} SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
    target_compile_definitions(${module} PRIVATE OCCT_HANDLE_NOCAST)
    target_link_libraries(${module} PRIVATE ${arg_LINK} suture_flags)
    add_dependencies(suture_${folder} ${module})
    # Programs elsewhere, which link the installed libraries.
    target_link_options(
        suture_${folder} INTERFACE
        "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CMAKE_INSTALL_LIBDIR}/suture>")
    install(TARGETS ${module} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/suture
                              COMPONENT program)
endfunction()

# suture_program(NAME FOLDER SOURCES file... LINK library...)
# What a folder does in a process of its own: suture_NAME, which program_on_demand finds on the
# program's run path, beside the modules.
function(suture_program name folder)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    set(program suture_program_${name})
    add_executable(${program} ${arg_SOURCES})
    set_target_properties(${program} PROPERTIES OUTPUT_NAME suture_${name}
                                                RUNTIME_OUTPUT_DIRECTORY ${SUTURE_MODULE_DIR}
                                                INSTALL_RPATH $ORIGIN BUILD_WITH_INSTALL_RPATH ON)
    target_include_directories(${program} PRIVATE ${SUTURE_INCLUDE_ROOT})
    target_link_libraries(${program} PRIVATE ${arg_LINK} suture_flags)
    add_dependencies(suture_${folder} ${program})
    target_link_options(
        suture_${folder} INTERFACE
        "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CMAKE_INSTALL_LIBDIR}/suture>")
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/suture
                               COMPONENT program)
endfunction()

# suture_group(NAME folder...): one name for several folders.
function(suture_group name)
    add_library(suture_${name} INTERFACE)
    add_library(suture::${name} ALIAS suture_${name})
    set_target_properties(suture_${name} PROPERTIES EXPORT_NAME ${name})
    list(TRANSFORM ARGN PREPEND suture_)
    target_link_libraries(suture_${name} INTERFACE ${ARGN})
    install(TARGETS suture_${name} EXPORT SutureTargets)
endfunction()

# The precompiled header is built once, by suture_occ, and shared.
function(suture_use_occt_header target)
    if(target STREQUAL suture_occ)
        target_precompile_headers(suture_occ PRIVATE ${PROJECT_SOURCE_DIR}/kernel/suture/occ/pch.h)
    else()
        target_precompile_headers(${target} REUSE_FROM suture_occ)
        target_compile_options(${target} PRIVATE -fPIC) # as the header: programs would take -fpie
    endif()
endfunction()

set(SUTURE_INCLUDE_ROOT ${PROJECT_SOURCE_DIR}/kernel)
set(SUTURE_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
