// The table that generator/make_albedo_table.cpp made, as a part of the program: the assembler takes the file as it is.
#include "lancer/world/albedo.h"

#include "lancer/kernel/bsdf/albedo.h"

extern "C" {
extern const float lancer_albedo_table[];
}

__asm__(
    ".pushsection .rodata\n"
    ".balign 64\n"
    ".globl lancer_albedo_table\n"
    ".type lancer_albedo_table, %object\n"
    "lancer_albedo_table:\n"
    ".incbin \"" LANCER_ALBEDO_TABLE
    "\"\n"
    ".size lancer_albedo_table, . - lancer_albedo_table\n"
    ".popsection\n");

namespace lancer {

std::span<const float> microfacet_albedo_table() { return {lancer_albedo_table, static_cast<std::size_t>(kernel::ALBEDO_VALUES)}; }

}  // namespace lancer
