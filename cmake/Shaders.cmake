# The GPU's entry points, shaders/*.comp, each a few lines that include kernel headers: compiled to SPIR-V and validated. This is also what
# keeps the kernel valid GLSL, so it is part of every build where glslc is found. Drivers optimise what they are given; glslc would take minutes.
find_program(GLSLC glslc)
find_program(SPIRV_VAL spirv-val)
file(GLOB shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*.comp)
if(NOT GLSLC)
    message(STATUS "glslc was not found: the kernel is not compiled as GLSL")
elseif(shaders)
    if(NOT SPIRV_VAL)
        message(STATUS "spirv-val was not found: compiled shaders are not validated")
    endif()
    set(modules "")
    foreach(shader IN LISTS shaders)
        cmake_path(GET shader STEM name)
        set(module ${PROJECT_BINARY_DIR}/shaders/${name}.spv)
        set(validate "")
        if(SPIRV_VAL)
            set(validate COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${module})
        endif()
        add_custom_command(
            OUTPUT ${module}
            COMMAND ${GLSLC} -Werror --target-env=vulkan1.3 -O0 -I ${PROJECT_SOURCE_DIR}/src -MD -MF ${module}.d -MT ${module} -o ${module} ${shader}
            ${validate}
            DEPENDS ${shader}
            DEPFILE ${module}.d
            COMMENT "Compiling shader ${name}"
            VERBATIM)
        list(APPEND modules ${module})
    endforeach()
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/shaders)
    add_custom_target(shaders ALL DEPENDS ${modules})
endif()
