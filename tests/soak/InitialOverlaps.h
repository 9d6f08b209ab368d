#pragma once

#include "tests/soak/BodyHulls.h"

#include <map>
#include <set>

namespace rubble::soak {

inline constexpr double kSinkFloor = 0.005;  // m: how far any body may sink into another one

/// The overlaps with which a scene begins, which play pushes apart: by the origins of both bodies.
class InitialOverlaps {
public:
    void start(const Moment& moment, BodyHulls& hulls) {
        for (const BodyFacts& one : moment.bodies) {
            for (const BodyFacts& other : moment.bodies) {
                if (one.body.number >= other.body.number) continue;
                const double depth = overlapDepth(hulls.of(one), hulls.of(other), kSinkFloor);
                if (depth > 0.0) m_depths[{one.body.origin, other.body.origin}] = depth;
                if (depth == 0.0) continue;
                if (!other.isDynamic()) m_inside.insert(one.body.origin);  // also if it is fixed: it may break
                if (!one.isDynamic()) m_inside.insert(other.body.origin);
            }
        }
    }
    double of(const BodyFacts& one, const BodyFacts& other) const {
        const auto found = m_depths.find(std::minmax(one.body.origin, other.body.origin));
        return found != m_depths.end() ? found->second : 0.0;
    }
    /// Whether a body, or what it was a part of, began deep in something static: it comes out, also through others.
    bool isInside(const BodyFacts& body) const { return m_inside.contains(body.body.origin); }

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> m_depths;
    std::set<std::uint32_t> m_inside;  // origins
};

}  // namespace rubble::soak
