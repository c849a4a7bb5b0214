// Rays against a large world: Embree's tree over all bounded objects. The only folder that knows Embree.
#pragma once

#include <memory>

#include "lancer/world/world.h"

namespace lancer {

// Analytic shapes are met by the kernel's own functions, and the hit on a triangle is computed again by the kernel, so that a tree and a walk
// through all objects give the same numbers. At the same distance the object with the smaller number is in front, and of a mesh its first
// triangle, in whatever order the tree asks. Planes have no bounds: each is tested against each ray.
class Tree {
public:
    // Builds on `threads` threads, 0 for all. `world` must outlive the tree. Throws MachineFailure when memory runs out.
    Tree(const World& world, int threads);
    ~Tree();
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    // For WorldRecord::tree.
    kernel::IntTable address() const { return reinterpret_cast<kernel::IntTable>(this); }

    struct Implementation;
    const Implementation& implementation() const { return *implementation_; }

private:
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lancer
