// The module: OpenVDB behind plain functions. No exception leaves it.
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <exception>
#include <istream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/import/volume/module/interface.h"

namespace {

using Reason = LancerVolumeReason;

void say(void* receiver, Reason sink, std::string_view words) { sink(receiver, words.data(), words.size()); }

// From the unit cube around the cells `box` to the world.
void put_map(const openvdb::math::Transform& transform, const openvdb::CoordBBox& box, double* to_world) {
    const openvdb::Vec3d low = box.min().asVec3d() - 0.5;
    const openvdb::Vec3d size = box.dim().asVec3d();
    const openvdb::Vec3d corner = transform.indexToWorld(low);
    for (int axis = 0; axis < 3; ++axis) {
        openvdb::Vec3d end = low;
        end[axis] += size[axis];
        const openvdb::Vec3d edge = transform.indexToWorld(end) - corner;
        for (int row = 0; row < 3; ++row) {
            to_world[4 * axis + row] = edge[row];
        }
        to_world[4 * axis + 3] = 0.0;
    }
    for (int row = 0; row < 3; ++row) {
        to_world[12 + row] = corner[row];
    }
    to_world[15] = 1.0;
}

void put(float value, float* to) { *to = value; }
void put(double value, float* to) { *to = static_cast<float>(value); }
void put(const openvdb::Vec3s& value, float* to) {
    for (int i = 0; i < 3; ++i) {
        to[i] = value[i];
    }
}

template <class Grid>
bool fill(const openvdb::GridBase& base, int channels, double most, void* receiver, LancerVolumeReceiver receive, Reason reason) {
    const auto& grid = static_cast<const Grid&>(base);
    const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
    if (box.empty()) {
        say(receiver, reason, "has no active cells");
        return false;
    }
    if (!grid.transform().isLinear()) {
        say(receiver, reason, "is not a grid of boxes: its map is not linear");
        return false;
    }
    const openvdb::Coord size = box.dim();
    const double count = double(size.x()) * double(size.y()) * double(size.z()) * double(channels);
    if (count > most) {
        say(receiver, reason,
            "spans " + std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " + std::to_string(size.z()) +
                " cells, more than lancer holds");
        return false;
    }
    std::vector<float> values(static_cast<std::size_t>(count));
    auto cells = grid.getConstAccessor();
    float* to = values.data();
    for (int z = box.min().z(); z <= box.max().z(); ++z) {
        for (int y = box.min().y(); y <= box.max().y(); ++y) {
            for (int x = box.min().x(); x <= box.max().x(); ++x, to += channels) {
                put(cells.getValue(openvdb::Coord(x, y, z)), to);
            }
        }
    }
    LancerVoxels voxels{{size.x(), size.y(), size.z()}, channels, {}, values.data()};
    put_map(grid.transform(), box, voxels.to_world);
    receive(receiver, &voxels);
    return true;
}

bool read(const char* bytes, std::size_t size, const char* name, double most, void* receiver, LancerVolumeReceiver receive, Reason reason) {
    try {
        openvdb::initialize();
        std::istringstream stream(std::string(bytes, size), std::ios::binary);
        openvdb::io::Stream file(stream, false);
        const openvdb::GridPtrVecPtr grids = file.getGrids();
        std::string known;
        for (const openvdb::GridBase::Ptr& grid : *grids) {
            known += (known.empty() ? "" : ", ") + grid->getName();
            if (*name != '\0' && grid->getName() != name) {
                continue;
            }
            if (grid->isType<openvdb::FloatGrid>()) {
                return fill<openvdb::FloatGrid>(*grid, 1, most, receiver, receive, reason);
            }
            if (grid->isType<openvdb::DoubleGrid>()) {
                return fill<openvdb::DoubleGrid>(*grid, 1, most, receiver, receive, reason);
            }
            if (grid->isType<openvdb::Vec3SGrid>()) {
                return fill<openvdb::Vec3SGrid>(*grid, 3, most, receiver, receive, reason);
            }
            if (*name != '\0') {
                say(receiver, reason, "has a grid \"" + grid->getName() + "\" of " + grid->valueType() + ", which is not read");
                return false;
            }
        }
        say(receiver, reason,
            *name != '\0' ? std::string("has no grid \"") + name + "\"; there are " + known : "has no grid of numbers; there are " + known);
    } catch (const std::exception& e) {
        say(receiver, reason, std::string("can't be read: ") + e.what());
    } catch (...) {
        say(receiver, reason, "can't be read");
    }
    return false;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const LancerVolumes lancer_volumes{lancer_volumes_version, read};
