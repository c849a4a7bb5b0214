# Everything that is not ours. What is optional says so when it is missing.
include(LibraryDependencies)

# For the program alone.
find_package(CLI11 REQUIRED)
find_package(SDL2 REQUIRED)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)  # its CMake files ask for tools that libopenimageio-dev lacks
pkg_check_modules(OCIO IMPORTED_TARGET OpenColorIO>=2.0)  # optional
find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h)  # optional; its CMake files are not made to be found
find_library(OPENVDB_LIBRARY openvdb)
if(NOT OPENVDB_LIBRARY OR NOT OPENVDB_INCLUDE_DIR)
    message(STATUS "OpenVDB was not found: .vdb files will not be read (Debian: libopenvdb-dev)")
endif()
if(NOT OCIO_FOUND)
    message(STATUS "OpenColorIO was not found: the view aces will not be there (Debian: libopencolorio-dev)")
endif()
