# ccache needs these two sloppiness settings to work together with a precompiled header.
find_program(SUTURE_CCACHE ccache)
if(SUTURE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${SUTURE_CCACHE})
endif()
