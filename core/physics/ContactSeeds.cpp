#include "core/physics/ContactSeeds.h"

#include "core/physics/NarrowPhase.h"

namespace rubble {
namespace {

Look lookAlong(const Hull& first, const Hull& second, Vec3f apart) {
    return rubble::lookAlong(first, second, {{}, apart}, kSpeculativeDistance, {});
}

}  // namespace

std::vector<ContactSeed> contactSeeds(const Shape& first, const Shape& second, Vec3 apart) {
    std::vector<ContactSeed> seeds;
    const Vec3f offset = toFloat(apart);
    for (std::uint32_t a = 0; a < first.hulls.size(); ++a) {
        for (std::uint32_t b = 0; b < second.hulls.size(); ++b) {
            const Look there = lookAlong(first.hulls[a], second.hulls[b], offset);
            const Look back = lookAlong(second.hulls[b], first.hulls[a], offset * -1.0f);
            if (there.manifold.count > 0 && back.manifold.count > 0) seeds.push_back({{a, b}, {there, back}});
        }
    }
    return seeds;
}

}  // namespace rubble
