#include "core/fracture/layer/SeedId.h"

namespace rubble {

std::string SeedId::text() const { return std::to_string(layer) + "." + std::to_string(index); }

std::optional<SeedId> seedOf(const DiagnosticPlace& place) {
    if (place.index == kNone) return std::nullopt;
    return SeedId{place.layer, place.index};
}

}  // namespace rubble
