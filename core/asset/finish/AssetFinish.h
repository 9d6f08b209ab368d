#pragma once

#include "core/asset/finish/FinishedSurface.h"
#include "core/asset/project/Project.h"

namespace rubble {

/// The finishes of an asset, which pictures and baked textures share. Those of an asset whose outside has an image are
/// those of the inside only.
struct AssetFinish {
    Finish outside = Finish::Plain, inside = Finish::Plain;
    BrickCourseFrame courses;
    int grainAxis = 0;  // x, y or z of the asset: its longest side
    bool isPlain() const { return outside == Finish::Plain && inside == Finish::Plain; }
    bool operator==(const AssetFinish&) const = default;
};
AssetFinish assetFinish(const Asset& asset, const AssetMaterials& materials);

/// The finish of one side with its colour, which is linear.
struct SurfaceFinish {
    FinishParameters parameters;
    Vec3 colour{1.0};
    Vec2 courseOrigin{0.0};
    int grainAxis = 0;

    /// At a point of the asset, m, on a face with a normal.
    FinishedSurface at(Vec3 point, Vec3 normal) const {
        return finishedSurface(parameters, point, normal, colour, courseOrigin, grainAxis);
    }
};
SurfaceFinish surfaceFinish(const AssetFinish& finish, FinishSide side, Vec3 colour);

}  // namespace rubble
