# lancer_made_table(target name folder COMMENT what SOURCES source...)
#
# A table of floats that a program of ours makes while lancer is built, as a part of `target`: folder/generator/make_<name>_table.cpp, together
# with the sources, writes build/<name>_table.bin, and folder/<name>_table.cpp takes that in by LANCER_TABLE_FILE (base/embedded_table.h).
function(lancer_made_table target name folder)
    cmake_parse_arguments(PARSE_ARGV 3 arg "" "COMMENT" "SOURCES")
    set(folder ${PROJECT_SOURCE_DIR}/src/lancer/${folder})
    set(table ${PROJECT_BINARY_DIR}/${name}_table.bin)
    set(maker lancer_make_${name}_table)
    list(TRANSFORM arg_SOURCES PREPEND ${folder}/)
    add_executable(${maker} ${folder}/generator/make_${name}_table.cpp ${arg_SOURCES})
    target_include_directories(${maker} PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${maker} PRIVATE lancer_compile glm::glm)
    # A second when optimised, minutes when not.
    target_compile_options(${maker} PRIVATE $<$<NOT:$<CONFIG:Release>>:-O2>)
    add_custom_command(OUTPUT ${table} COMMAND ${maker} ${table} DEPENDS ${maker} COMMENT "${arg_COMMENT}" VERBATIM)
    # A target of its own: the sources of several targets must not each make the file.
    add_custom_target(lancer_${name}_table_file DEPENDS ${table})
    add_dependencies(${target} lancer_${name}_table_file)
    set_source_files_properties(${folder}/${name}_table.cpp PROPERTIES
        COMPILE_DEFINITIONS "LANCER_TABLE_FILE=\"${table}\""
        OBJECT_DEPENDS ${table})
endfunction()
