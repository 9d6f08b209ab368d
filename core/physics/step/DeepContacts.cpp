#include "core/physics/step/DeepContacts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {
namespace {

constexpr float kRate = 12.0f;        // 1/s: the part of the excess of an overlap
constexpr float kFastest = 0.1f;      // m/s: of the displacement
constexpr float kImpactSpeed = 0.2f;  // m/s, along the normal: faster ones are impacts

/// A contact that overlaps by more than kDeepOverlap.
struct DeepContact {
    std::uint32_t contact = 0;
    std::uint32_t first = 0, second = 0;  // bodies
    Vec3f way{0.0f, 0.0f, 0.0f};          // m: of the second body, relative to the first
};

void findDeep(const ContactBlock& block, float dt, std::vector<DeepContact>& found) {
    for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
        float depth = 0.0f;
        for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
            const PointRows& point = block.points[i];
            if (std::abs(point.approach[lane]) < kImpactSpeed) depth = std::max(depth, -point.separation[lane]);
        }
        const float excess = depth - kDeepOverlap / block.stiffening[lane];
        if (!(excess > 0.0f)) continue;
        found.push_back({block.contact[lane], block.first[lane], block.second[lane],
                         block.normal.at(lane) * std::min(std::min(0.5f, kRate * dt) * excess, kFastest * dt)});
    }
}

}  // namespace

void displaceDeepContacts(WorldState& state, std::span<const BlockList> blocks, float dt) {
    std::vector<DeepContact> deep;
    for (const BlockList& list : blocks) {
        for (const ContactBlock* block : list) findDeep(*block, dt, deep);
    }
    std::ranges::sort(deep, {}, &DeepContact::contact);
    for (const DeepContact& one : deep) {
        const bool isFirst = state.bodies[one.first].isDynamic(), isSecond = state.bodies[one.second].isDynamic();
        const float share = isFirst && isSecond ? 0.5f : 1.0f;
        if (isFirst) state.motions[one.first].deltaPosition -= one.way * share;
        if (isSecond) state.motions[one.second].deltaPosition += one.way * share;
    }
}

}  // namespace rubble
