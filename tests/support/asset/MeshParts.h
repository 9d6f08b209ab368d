#pragma once

#include "core/asset/mesh/FragmentMesh.h"
#include "core/io/exchange/MeshPart.h"
#include "tests/support/asset/Fragments.h"

namespace rubble {

/// The unit square, 2 deep, cut at x = 0.5.
inline std::vector<MeshPart> halves() {
    const Asset asset = assetOf(unitSquare(), 2.0);
    const Bake bake = halvedSquare();
    const BakedFragment left = bake.fragment(0), right = bake.fragment(1);
    return {{"wall0", fragmentMesh(left, asset), left.solid.offset()},
            {"wall1", fragmentMesh(right, asset), right.solid.offset()}};
}

}  // namespace rubble
