find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
if(SUTURE_MIMALLOC)
    find_package(mimalloc REQUIRED) # 2 or 3; its version file takes one of them only
    if(mimalloc_VERSION VERSION_LESS 2)
        message(FATAL_ERROR "mimalloc ${mimalloc_VERSION} is too old: Suture needs 2 or newer")
    endif()
endif()
find_package(OpenCASCADE REQUIRED) # its version file takes no "7.6 or later"
include(occt_versions)
find_path(SUTURE_BOOST_POLYGON boost/polygon/voronoi.hpp REQUIRED) # headers only: no CMake package
find_path(SUTURE_ZIP_HEADER zip.h REQUIRED) # libzip; its CMake package names programs that Debian keeps apart
