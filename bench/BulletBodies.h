#pragma once

#include "core/physics/BodyScene.h"

#include <memory>

namespace rubble::bench {

/// The peer: a scene moved by Bullet on one thread, its bodies never asleep. Friction of a pair is the root of the product,
/// as ours. Hulls keep a margin of 1 mm in place of Bullet's 40, which would make fragments rounder than they are wide.
class BulletBodies {
public:
    explicit BulletBodies(const BodyScene& scene);
    ~BulletBodies();

    void step(double dt);
    /// Where the frames of the bodies' shapes are, in the scene's order.
    std::vector<Pose> poses() const;
    std::size_t contactPoints() const;

private:
    struct Data;
    std::unique_ptr<Data> m_data;
};

}  // namespace rubble::bench
