// A file of floats that was made while lancer was built, as a part of the program: the assembler takes it as it is.
#pragma once

// Defines the array `name` from the file `path`, a string literal. Outside namespaces.
#define LANCER_EMBED_TABLE(name, path)     \
    extern "C" {                           \
    extern const float name[];             \
    }                                      \
    __asm__(                               \
        ".pushsection .rodata\n"           \
        ".balign 64\n"                     \
        ".globl " #name                    \
        "\n"                               \
        ".type " #name ", %object\n" #name \
        ":\n"                              \
        ".incbin \"" path                  \
        "\"\n"                             \
        ".size " #name ", . - " #name      \
        "\n"                               \
        ".popsection\n")
