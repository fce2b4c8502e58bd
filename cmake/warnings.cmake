# suture_flags: what every target of ours is compiled with. No fused multiply-add, so that results
# are the same on every machine with the same library versions.
add_library(suture_flags INTERFACE)
target_compile_options(
    suture_flags INTERFACE -ffp-contract=off -fpch-preprocess -Wall -Wextra -Wpedantic -Wshadow
                           -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set_target_properties(suture_flags PROPERTIES INTERFACE_COMPILE_OPTIONS
        "-ffp-contract=off;-Wall;-Wextra;-Wpedantic;-Wshadow;-Wnon-virtual-dtor;-Woverloaded-virtual")
endif()
if(SUTURE_STRICT)
    target_compile_options(suture_flags INTERFACE -Werror)
endif()
