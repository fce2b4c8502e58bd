# What OCCT 7.8 (Debian 13) calls otherwise than 7.6 (Debian 12): its libraries for data exchange. They
# are linked by their old names everywhere.
foreach(pair TKXDESTEP=TKDESTEP TKSTEP=TKDESTEP TKXDEIGES=TKDEIGES TKIGES=TKDEIGES)
    string(REPLACE "=" ";" pair ${pair})
    list(GET pair 0 old)
    list(GET pair 1 new)
    if(NOT TARGET ${old} AND TARGET ${new})
        add_library(${old} INTERFACE IMPORTED GLOBAL)
        set_property(TARGET ${old} PROPERTY INTERFACE_LINK_LIBRARIES ${new})
    endif()
endforeach()
