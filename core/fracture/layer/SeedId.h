#pragma once

#include "core/base/Diagnostic.h"
#include "core/geometry/predicates/Vec.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace rubble {

/// A persistent seed id: it does not change when other seeds are added, deleted or moved.
struct SeedId {
    std::uint32_t layer = 0;  // the layer's id
    std::uint32_t index = 0;  // within the layer
    auto operator<=>(const SeedId&) const = default;
    /// The id as text: "layer.index".
    std::string text() const;
};

/// The seed or cut that a diagnostic is about; nothing if it is about none.
std::optional<SeedId> seedOf(const DiagnosticPlace& place);

/// A manual change to one scattered seed of a layer.
struct SeedOverride {
    std::uint32_t index = 0;  // of the seed in its layer
    bool isDeleted = false;
    Vec2 position{0.0, 0.0};  // its new position, unless deleted
    double height = 0.0;      // its new z, m, of seeds in space
    bool operator==(const SeedOverride&) const = default;
};

/// The maximum number of seeds of a pattern; more would need too much memory and time.
inline constexpr std::uint32_t kMaxSeeds = 10'000'000;

}  // namespace rubble
