// Any bytes as OBJ: a sound mesh or at least one error, and nothing else.
#include "lancer/import/obj/obj.h"

#include <cstddef>
#include <cstdint>

#include "checked_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lancer::Diagnostics diagnostics;
    const auto mesh = lancer::read_obj({reinterpret_cast<const char*>(data), size}, "fuzz.obj", diagnostics);
    check_mesh_of_fuzzer(mesh, diagnostics);
    return 0;
}
