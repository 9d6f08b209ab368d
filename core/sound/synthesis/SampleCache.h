#pragma once

#include "core/sound/synthesis/SoundSample.h"

#include <map>
#include <memory>
#include <tuple>

namespace rubble {

/// A mono sample that is shared.
using SharedSample = std::shared_ptr<const std::vector<float>>;

/// Samples that were made. Masses between the same two powers of two sound alike. Not thread-safe.
class SampleCache {
public:
    /// The sample of a recipe whose random seed follows from the rest and from the number of the take.
    SharedSample sampleOf(const SoundRecipe& recipe, std::uint64_t take);

private:
    std::map<std::tuple<CueKind, SoundMaterial, SoundMaterial, int, std::uint64_t>, SharedSample> m_samples;
};

}  // namespace rubble
