#include "core/fracture/pattern/PatternKind.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>

namespace rubble {
namespace {

template <class Kind>
PatternKind patternKind() {
    PatternKind kind{Kind::kKind, nullptr, nullptr, nullptr};
    kind.summary = [](const LayerParameters& parameters) {
        if constexpr (requires(const Kind& layer) { layer.summary(); }) return std::get<Kind>(parameters).summary();
        return Kind::kKind.LayerKind::summary;
    };
    kind.defaultsIn = [](const Box3& bounds) -> LayerParameters {
        if constexpr (requires { Kind::defaultsFor(bounds); }) return Kind::defaultsFor(bounds);
        return Kind{};
    };
    if constexpr (requires(const Kind& layer) { layer.elementCount(); }) {
        kind.elementCount = [](const LayerParameters& parameters) { return std::get<Kind>(parameters).elementCount(); };
    }
    kind.isSpatial = Kind::kKind.role == LayerRole::Measures ||
                     requires(const Kind& layer, const SolidLayerContext& context, SeedSet& seeds) {
        layer.applyInSolid(context, seeds);
    };
    return kind;
}

/// The kinds of the alternatives of a variant.
template <class... Kinds>
const auto& kindsOf(const std::variant<Kinds...>*) {
    static const std::array<PatternKind, sizeof...(Kinds)> kKinds{patternKind<Kinds>()...};
    return kKinds;
}
const auto& allKinds() { return kindsOf(static_cast<const LayerParameters*>(nullptr)); }

}  // namespace

const PatternKind& kindOf(const LayerParameters& parameters) { return allKinds()[parameters.index()]; }

bool isWritten(const LayerParameter& parameter, const LayerParameters& layer) {
    const auto isDefault = [&]<class Kind>(const Kind&) {
        const Kind defaults;
        return parameter.readFrom(&defaults) == parameter.read(layer);
    };
    return !parameter.isSpatial || !std::visit(isDefault, layer);
}

std::span<const PatternKind* const> patternKinds() {
    static const auto kPointers = [] {
        std::array<const PatternKind*, std::variant_size_v<LayerParameters>> pointers{};
        for (std::size_t k = 0; k < pointers.size(); ++k) pointers[k] = &allKinds()[k];
        return pointers;
    }();
    return kPointers;
}

}  // namespace rubble
