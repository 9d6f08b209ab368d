#pragma once

#include "core/physics/world/BodyScene.h"

#include <memory>

namespace rubble::bench {

/// A scene simulated by Bullet on one thread, without sleeping. Friction of a pair is the geometric mean, as ours.
/// Hulls have a margin of 1 mm instead of Bullet's 40 mm, which would round off whole fragments.
class BulletBodies {
public:
    explicit BulletBodies(const BodyScene& scene);
    ~BulletBodies();

    void step(double dt);
    /// The poses of the bodies' shape frames, in the scene's order.
    std::vector<Pose> poses() const;
    std::size_t contactPoints() const;

private:
    struct Data;
    std::unique_ptr<Data> m_data;
};

}  // namespace rubble::bench
