#pragma once

#include "core/base/Random.h"
#include "core/geometry/predicates/Vec.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble::bench {

using SeedList = std::vector<Vec2>;

/// Sets of uniform random seeds in the unit square: at least three, more if they are small; the same in every run.
inline std::vector<SeedList> seedSets(std::size_t seedsInEach) {
    constexpr std::size_t kSeedsInAll = 200'000;
    constexpr std::uint64_t kRandomSeed = 2;
    std::vector<SeedList> sets(std::clamp<std::size_t>(kSeedsInAll / seedsInEach, 3, 256), SeedList(seedsInEach));
    Random random(kRandomSeed);
    for (SeedList& seeds : sets) {
        for (Vec2& seed : seeds) seed = {random.unit(), random.unit()};
    }
    return sets;
}

/// Prepared inputs in rotation, so that successive iterations of a benchmark have different inputs.
template <class Input>
class InputRotation {
public:
    explicit InputRotation(std::vector<Input> inputs) : m_inputs(std::move(inputs)) {}
    const Input& next() { return m_inputs[++m_next % m_inputs.size()]; }

private:
    std::vector<Input> m_inputs;
    std::size_t m_next = 0;
};

}  // namespace rubble::bench
