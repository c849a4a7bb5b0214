# lancer_isa_variants(target source...)
#
# Compiles each source once for each instruction set and puts all the objects into `target`. A source tells its variants apart by
#   LANCER_ISA    sse4_2, avx2, avx512f: a name to make namespaces and functions of (`native` where there is only one)
#   LANCER_LANES  4, 8, 16: how many floats fit into a register
# and `target` picks one at run time. Always optimised, in debug builds too: unoptimised SIMD wrappers are a hundred times slower.
#
# Whatever such a source defines must have internal linkage or carry LANCER_ISA in its name: of an inline function that several objects
# define, the linker keeps any one, and an AVX-512 std::sort would crash every other machine. The test architecture.isa_symbols looks.
function(lancer_isa_variants target)
    if(LANCER_X86_64)
        set(variants sse4_2 avx2 avx512f)
        set(lanes_sse4_2 4)
        set(flags_sse4_2 -march=x86-64-v2)
        set(lanes_avx2 8)
        set(flags_avx2 -march=x86-64-v3 -mprefer-vector-width=256)
        set(lanes_avx512f 16)
        set(flags_avx512f -march=x86-64-v4 -mprefer-vector-width=512)
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            # g++ 12 warns of its own _mm512_undefined_ps [GCC bug 105593].
            list(APPEND flags_avx512f -Wno-uninitialized -Wno-maybe-uninitialized)
        endif()
    else()
        set(variants native)
        set(lanes_native 4)
        set(flags_native "")
    endif()
    get_target_property(links ${target} LINK_LIBRARIES)
    foreach(source IN LISTS ARGN)
        cmake_path(GET source STEM stem)
        foreach(isa IN LISTS variants)
            set(objects ${target}_${stem}_${isa})
            add_library(${objects} OBJECT ${source})
            set_target_properties(${objects} PROPERTIES LANCER_ISA ${isa})
            target_compile_definitions(${objects} PRIVATE LANCER_ISA=${isa} LANCER_LANES=${lanes_${isa}})
            target_compile_options(${objects} PRIVATE ${flags_${isa}} $<$<NOT:$<CONFIG:Release>>:-O2>)
            target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR}/src)
            target_link_libraries(${objects} PRIVATE ${links})
            target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
            set_property(GLOBAL APPEND PROPERTY LANCER_ISA_OBJECTS ${objects})
        endforeach()
    endforeach()
endfunction()
