#pragma once

#include "core/base/Random.h"
#include "core/play/session/Session.h"

namespace rubble::test {

/// A throw, a blow or a blast at a random instance.
inline ShotInput randomShot(const Project& project, Random& random) {
    const Instance& instance = project.instances[random.below(project.instances.size())];
    const Vec3 target = instance.pose.position + Vec3(random.between(-0.5, 0.5), random.between(0.0, 1.0), 0.0);
    const Vec3 side(random.between(-2.0, 2.0), random.between(0.2, 3.0), random.below(2) == 0 ? 4.0 : -4.0);
    switch (random.below(5)) {
        case 0: return {"blow", Hammer{.at = target, .impulse = Vec3(0.0, 0.0, random.between(500.0, 5000.0))}};
        case 1: return {"blast", Blast{.at = target + 0.2 * side, .impulse = 3000.0, .radius = 2.0}};
        default:
            return {"throw", Throw{.kind = random.below(2) == 0 ? ProjectileKind::Box : ProjectileKind::Ball,
                                   .size = Vec3(random.between(0.1, 0.6)),
                                   .mass = random.between(5.0, 200.0),
                                   .from = target + side,
                                   .to = target,
                                   .speed = random.between(5.0, 40.0)}};
    }
}

/// Adds shots within the first half second.
inline void addRandomShots(Session& session, Random& random) {
    const std::uint64_t count = 1 + random.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
        const Status added = session.add(TimedInput{random.below(30), randomShot(session.scene().project, random)});
        if (!added) qFatal("%s", added.error().message.c_str());
    }
}

}  // namespace rubble::test
