#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/sampling/ScatterArea.h"

namespace rubble {
namespace {

constexpr std::array kParameters{
    parameter<&UniformScatter::count>(kCountParameter),
    parameter<&UniformScatter::domain>(kDomainParameter),
};

}  // namespace

constinit const PatternKind UniformScatter::kKind{
    .name = "uniform",
    .caption = "Uniform",
    .hint = "Uniformly random seeds",
    .icon = "layer-uniform",
    .summary = [](const LayerParameters&) { return "{count|1 seed|%1 seeds}"; },
    .role = LayerRole::Scatters,
    .parameters = kParameters,
    .defaultsFor = [](const Box2&) -> LayerParameters { return UniformScatter{}; },
    .isRandom = true};

Status UniformScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Polygon filled = ScatterArea::domain(context.outline, domain);
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(filled);
    if (!area) return area.error();
    return scatter(*wanted, *area, context, seeds);
}

}  // namespace rubble
