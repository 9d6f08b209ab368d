#pragma once

#include "core/geometry/mesh/Mesh.h"

namespace rubble {

/// The box [-1, 1] x [-1, 1] x [-1, 1], volume 8: front, back, bottom and right are outside, top and left inside.
inline Mesh boxMesh() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1},
                      {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
    mesh.uvs = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 1}, {0, -1}, {2, 1}, {2, -1}};
    mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    mesh.corners = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {7, 3}, {6, 2}, {5, 1}, {4, 0}, {0, 4}, {4, 5}, {5, 7}, {1, 6},
                    {1, 4}, {5, 5}, {6, 7}, {2, 6}, {2, 4}, {6, 5}, {7, 7}, {3, 6}, {3, 4}, {7, 5}, {4, 7}, {0, 6}};
    for (std::uint32_t i = 0; i < 6; ++i) {
        mesh.faces.push_back({4 * i, 4, i, 0, i < 4 ? FaceSide::Outside : FaceSide::Inside});
    }
    return mesh;
}

}  // namespace rubble
