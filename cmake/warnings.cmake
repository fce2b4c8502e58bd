# suture_flags: what every target of ours is compiled with. No fused multiply-add, so that results
# are the same on every machine with the same library versions.
add_library(suture_flags INTERFACE)
target_compile_options(
    suture_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                           -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(suture_flags INTERFACE -Wcast-qual)
    if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        target_compile_options(suture_flags INTERFACE -fpch-preprocess) # asked for by ccache
    endif()
endif()
if(SUTURE_STRICT)
    target_compile_options(suture_flags INTERFACE -Werror)
endif()
