#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/geometry/search/Box3.h"
#include "tests/soak/Moment.h"

#include <map>
#include <vector>

namespace rubble::soak {

/// The exact hulls of bodies, kept from step to step.
class BodyHulls {
public:
    struct Posed {
        const std::vector<Polytope>* hulls = nullptr;
        Pose pose;
        Box3 box;  // in the world
    };

    /// Of a body where it is. Borrowed until the body loses nodes.
    Posed of(const BodyFacts& facts);
    /// Forgets the bodies that are gone.
    void keepOnly(const Moment& moment);

private:
    struct Known {
        std::size_t nodes = 0;
        std::uint32_t fragment = kNone;
        std::vector<Polytope> hulls;
    };
    std::map<std::uint32_t, Known> m_known;  // by the body's number
};

/// The depth at which two bodies overlap, m; 0 where it is no more than `least`, m.
double overlapDepth(const BodyHulls::Posed& first, const BodyHulls::Posed& second, double least);
/// Whether a point is in a hull of a body.
bool contains(const BodyHulls::Posed& body, Vec3 point);
/// The length of the part of a segment that is deeper than `depth` in a hull of a body, m; only of hulls in which
/// neither end is.
double lengthThrough(const BodyHulls::Posed& body, Vec3 from, Vec3 to, double depth);

}  // namespace rubble::soak
