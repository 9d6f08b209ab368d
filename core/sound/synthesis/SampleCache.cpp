#include "core/sound/synthesis/SampleCache.h"

#include "core/base/Random.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kLightest = 1e-3, kHeaviest = 1e5;  // kg: bodies beyond sound like these

}  // namespace

SharedSample SampleCache::sampleOf(const SoundRecipe& recipe, std::uint64_t take) {
    int size = 0;
    std::frexp(std::clamp(recipe.mass, kLightest, kHeaviest), &size);
    const auto key = std::tuple(recipe.kind, recipe.first, recipe.second, size, take);
    const auto found = m_samples.find(key);
    if (found != m_samples.end()) return found->second;
    SoundRecipe made = recipe;
    made.mass = std::ldexp(0.75, size);
    const auto pair =
        static_cast<std::uint64_t>(recipe.first) * kSoundMaterials + static_cast<std::uint64_t>(recipe.second);
    made.randomSeed = mixSeeds(static_cast<std::uint64_t>(recipe.kind), take);
    made.randomSeed = mixSeeds(made.randomSeed, pair);
    made.randomSeed = mixSeeds(made.randomSeed, static_cast<std::uint64_t>(size + 1000));
    return m_samples[key] = std::make_shared<const std::vector<float>>(synthesized(made));
}

}  // namespace rubble
