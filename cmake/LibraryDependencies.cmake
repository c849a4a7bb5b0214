# What the libraries link. Read when lancer is built, and again by lancerConfig.cmake when another project uses the installed libraries.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED)
find_package(xsimd REQUIRED)
set_target_properties(xsimd PROPERTIES INTERFACE_LINK_LIBRARIES "")  # Debian's names xtl, which is headers, not packaged with it, and not used here
if(NOT TARGET PkgConfig::TOMLPLUSPLUS)
    pkg_check_modules(TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
endif()
if(NOT TARGET PkgConfig::OPENEXR)
    pkg_check_modules(OPENEXR REQUIRED IMPORTED_TARGET OpenEXR)  # its CMake files complain about Python libraries that nobody asked for
endif()
