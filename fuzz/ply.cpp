// Any bytes as PLY: a sound mesh or at least one error, and nothing else.
#include "lancer/import/ply/ply.h"

#include <cstddef>
#include <cstdint>

#include "checked_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lancer::Diagnostics diagnostics;
    const auto mesh = lancer::read_ply({reinterpret_cast<const char*>(data), size}, "fuzz.ply", diagnostics);
    check_mesh_of_fuzzer(mesh, diagnostics);
    return 0;
}
