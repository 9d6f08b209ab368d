#pragma once

#include "core/asset/finish/FinishedSurface.h"
#include "core/asset/project/Project.h"

namespace rubble {

/// The finishes of an asset, which pictures and baked textures share. Those of an asset whose outside has an image are
/// those of the inside only.
struct AssetFinish {
    Finish outside = Finish::Plain, inside = Finish::Plain;
    BrickCourseFrame courses;
    FinishFrame frame;  // the grain is along the longest side
    bool isPlain() const { return outside == Finish::Plain && inside == Finish::Plain; }
    bool operator==(const AssetFinish&) const = default;
};
/// `orientation`: of an instance. Courses rise where it does, but those of a layer of bricks along y of the asset.
AssetFinish assetFinish(const Asset& asset, const AssetMaterials& materials,
                        const Quat& orientation = Quat(1.0, 0.0, 0.0, 0.0));
/// The direction in which courses rise on an instance, as in FinishFrame.
int courseUp(const Asset& asset, const Quat& orientation);
/// That of the first instance of an asset in a project; without one, upright.
Quat placedOrientation(const Project& project, Id asset);

/// The finish of one side with its colour, which is linear.
struct SurfaceFinish {
    FinishParameters parameters;
    Vec3 colour{1.0};
    FinishFrame frame;

    /// At a point of the asset, m, on a face with a normal.
    FinishedSurface at(Vec3 point, Vec3 normal) const {
        return finishedSurface(parameters, point, normal, colour, frame);
    }
};
SurfaceFinish surfaceFinish(const AssetFinish& finish, FinishSide side, Vec3 colour);

}  // namespace rubble
