# Everything that is not ours. What is optional says so when it is missing.
include(LibraryDependencies)

# For the program alone.
find_package(CLI11 REQUIRED)
find_package(SDL2 REQUIRED)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)  # its CMake files ask for tools that libopenimageio-dev lacks
