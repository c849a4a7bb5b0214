# The table of smooth spectra, made by a program of ours while lancer is built (src/lancer/spectrum/upsample.h), as a part of `target`.
function(lancer_upsampling_table target)
    set(folder ${PROJECT_SOURCE_DIR}/src/lancer/spectrum)
    set(table ${PROJECT_BINARY_DIR}/upsampling_table.bin)
    add_executable(lancer_make_upsampling_table
        ${folder}/generator/make_upsampling_table.cpp ${folder}/upsample_fit.cpp ${folder}/curve.cpp ${folder}/illuminant.cpp
        ${folder}/fluorescent.cpp ${folder}/sensor.cpp ${folder}/observer.cpp ${folder}/cie_1931.cpp)
    target_include_directories(lancer_make_upsampling_table PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(lancer_make_upsampling_table PRIVATE lancer_compile glm::glm)
    # 800 000 fits: a second when optimised.
    target_compile_options(lancer_make_upsampling_table PRIVATE $<$<NOT:$<CONFIG:Release>>:-O2>)
    add_custom_command(
        OUTPUT ${table}
        COMMAND lancer_make_upsampling_table ${table}
        DEPENDS lancer_make_upsampling_table
        COMMENT "Fitting smooth spectra to the colours of sRGB"
        VERBATIM)
    # A target of its own: the sources of several targets must not each make the file.
    add_custom_target(lancer_upsampling_table_file DEPENDS ${table})
    add_dependencies(${target} lancer_upsampling_table_file)
    set_source_files_properties(${folder}/upsample_table.cpp PROPERTIES
        COMPILE_DEFINITIONS "LANCER_UPSAMPLING_TABLE=\"${table}\""
        OBJECT_DEPENDS ${table})
endfunction()
