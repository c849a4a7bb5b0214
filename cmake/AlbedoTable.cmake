# The table of what rough surfaces reflect, made by a program of ours while lancer is built (src/lancer/kernel/bsdf/albedo.h), as a part of `target`.
function(lancer_albedo_table target)
    set(folder ${PROJECT_SOURCE_DIR}/src/lancer/world)
    set(table ${PROJECT_BINARY_DIR}/albedo_table.bin)
    add_executable(lancer_make_albedo_table ${folder}/generator/make_albedo_table.cpp)
    target_include_directories(lancer_make_albedo_table PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(lancer_make_albedo_table PRIVATE lancer_compile glm::glm)
    target_compile_options(lancer_make_albedo_table PRIVATE $<$<NOT:$<CONFIG:Release>>:-O2>)
    add_custom_command(
        OUTPUT ${table}
        COMMAND lancer_make_albedo_table ${table}
        DEPENDS lancer_make_albedo_table
        COMMENT "Measuring what rough surfaces reflect"
        VERBATIM)
    # A target of its own: the sources of several targets must not each make the file.
    add_custom_target(lancer_albedo_table_file DEPENDS ${table})
    add_dependencies(${target} lancer_albedo_table_file)
    set_source_files_properties(${folder}/albedo.cpp PROPERTIES
        COMPILE_DEFINITIONS "LANCER_ALBEDO_TABLE=\"${table}\""
        OBJECT_DEPENDS ${table})
endfunction()
