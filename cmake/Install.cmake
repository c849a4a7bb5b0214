# Installed: the program, what it reads, and lancer::lancer for other CMake projects.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY LANCER_LIBRARIES)
install(TARGETS ${libraries} lancer_all EXPORT lancer ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/lancer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.h" PATTERN app EXCLUDE PATTERN module EXCLUDE)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/lancer)
install(EXPORT lancer NAMESPACE lancer:: FILE lancerTargets.cmake DESTINATION ${package})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lancerConfig.cmake.in ${PROJECT_BINARY_DIR}/lancerConfig.cmake
    INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lancerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lancerConfig.cmake ${PROJECT_BINARY_DIR}/lancerConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/LibraryDependencies.cmake DESTINATION ${package})

if(TARGET lancer_images)
    install(TARGETS lancer_images LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lancer)
endif()
if(TARGET lancer_aces)
    install(TARGETS lancer_aces LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lancer)
endif()
if(TARGET lancer_volumes)
    install(TARGETS lancer_volumes LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/lancer)
endif()
if(TARGET lancer)
    install(TARGETS lancer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(FILES ${PROJECT_BINARY_DIR}/lancer.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/lancer)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/lancer)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
