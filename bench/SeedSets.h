#pragma once

#include "core/base/Random.h"
#include "core/geometry/Vec.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble::bench {

using SeedList = std::vector<Vec2>;

/// Sets of uniform random seeds in the unit square: at least three, more of few seeds, the same in every run.
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

/// Inputs made beforehand and handed out in turn, so that no round of a benchmark sees the input of the one before.
template <class Input>
class InTurn {
public:
    explicit InTurn(std::vector<Input> inputs) : m_inputs(std::move(inputs)) {}
    const Input& next() { return m_inputs[++m_turn % m_inputs.size()]; }

private:
    std::vector<Input> m_inputs;
    std::size_t m_turn = 0;
};

}  // namespace rubble::bench
