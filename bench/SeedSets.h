#pragma once

#include "core/base/Random.h"
#include "core/geometry/Vec.h"

#include <algorithm>
#include <vector>

namespace rubble::bench {

/// Sets of uniform random seeds in the unit square, made beforehand and handed out in turn, so that no run sees the
/// input of the one before.
class SeedSets {
public:
    explicit SeedSets(std::size_t count) {
        m_sets.resize(std::clamp<std::size_t>(kSeedsInAll / count, 3, 256));
        Random random(kFirstSeed);
        for (std::vector<Vec2>& seeds : m_sets) {
            seeds.resize(count);
            for (Vec2& seed : seeds) seed = {random.unit(), random.unit()};
        }
    }
    const std::vector<Vec2>& next() { return m_sets[++m_turn % m_sets.size()]; }

private:
    static constexpr std::size_t kSeedsInAll = 200'000;
    static constexpr std::uint64_t kFirstSeed = 2;
    std::vector<std::vector<Vec2>> m_sets;
    std::size_t m_turn = 0;
};

}  // namespace rubble::bench
