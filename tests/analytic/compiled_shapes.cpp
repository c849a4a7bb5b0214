#include "analytic/compiled_shapes.h"

#include <stdexcept>

#include "lancer/world/compile.h"

namespace lancer::tests {

std::vector<Shape> shapes_of(const World& world) {
    std::vector<Shape> shapes;
    for (const kernel::ObjectRecord& object : world.objects) {
        const auto i = static_cast<std::size_t>(object.index);
        Shape shape;
        shape.kind = object.kind;
        switch (object.kind) {
            case kernel::OBJECT_SPHERE:
                shape.sphere = world.spheres[i];
                break;
            case kernel::OBJECT_BOX:
                shape.box = world.boxes[i];
                break;
            case kernel::OBJECT_PLANE:
                shape.plane = world.planes[i];
                break;
            case kernel::OBJECT_TRIANGLE:
                shape.triangle = world.triangles[i];
                break;
            case kernel::OBJECT_MESH:
                throw std::runtime_error("a mesh of many triangles is no single shape");
            default:
                shape.placed = world.placed[i];
        }
        shapes.push_back(shape);
    }
    return shapes;
}

Shape compile_shape(const scene::Shape& shape, const glm::dmat4& to_world) {
    scene::Scene scene;
    scene.cameras.emplace_back();
    scene.materials.emplace_back();
    scene.objects.push_back({"", shape, 0, to_world, {}});
    Diagnostics diagnostics;
    const auto world = compile_world(scene, scene.cameras[0], diagnostics);
    if (!world) {
        throw std::runtime_error(to_string(diagnostics.list().at(0)));
    }
    return shapes_of(*world).at(0);
}

}  // namespace lancer::tests
