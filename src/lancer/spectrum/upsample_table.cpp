// The table that generator/make_upsampling_table.cpp made, as a part of the program: the assembler takes the file as it is.
#include "lancer/spectrum/upsample.h"

extern "C" {
extern const float lancer_upsampling_table[];
}

__asm__(
    ".pushsection .rodata\n"
    ".balign 64\n"
    ".globl lancer_upsampling_table\n"
    ".type lancer_upsampling_table, %object\n"
    "lancer_upsampling_table:\n"
    ".incbin \"" LANCER_UPSAMPLING_TABLE
    "\"\n"
    ".size lancer_upsampling_table, . - lancer_upsampling_table\n"
    ".popsection\n");

namespace lancer {

std::span<const float> upsampling_table() { return {lancer_upsampling_table, static_cast<std::size_t>(upsampling_values)}; }

}  // namespace lancer
