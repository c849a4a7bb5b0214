# The scenes that the program carries with it, so that it shows its figures wherever it is started: everything under scenes/ but what only
# benchmarks, tests and documentation use, and the scripts that made the meshes and textures.
function(lancer_embed_scenes target)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/scenes/*)
    list(FILTER files EXCLUDE REGEX "^scenes/(benchmark|analytic|gltf)/|\\.py$")
    list(SORT files)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded_scenes.cpp)
    list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE dependencies)
    add_custom_command(
        OUTPUT ${generated}
        COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DFOLDER=${PROJECT_SOURCE_DIR} -DOUTPUT=${generated}
            -P ${PROJECT_SOURCE_DIR}/cmake/WriteEmbedded.cmake
        DEPENDS ${dependencies} ${PROJECT_SOURCE_DIR}/cmake/WriteEmbedded.cmake ${PROJECT_SOURCE_DIR}/cmake/EmbedScenes.cmake
        COMMENT "Embedding the scenes"
        VERBATIM)
    set_source_files_properties(${generated} PROPERTIES OBJECT_DEPENDS "${dependencies}")
    target_sources(${target} PRIVATE ${generated})
endfunction()
