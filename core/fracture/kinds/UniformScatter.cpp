#include "core/fracture/kinds/UniformScatter.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/SolidScatterDomain.h"

namespace rubble {
namespace {

constexpr std::array kUniformScatterParameters{
    parameter<&UniformScatter::count>(kCountParameter),
    parameter<&UniformScatter::domain>(kDomainParameter),
};

}  // namespace

constinit const LayerKind UniformScatter::kKind{.name = "uniform",
                                                .caption = "Uniform",
                                                .hint = "Uniformly random seeds",
                                                .icon = "layer-uniform",
                                                .summary = "{count|1 seed|%1 seeds}",
                                                .role = LayerRole::Scatters,
                                                .parameters = kUniformScatterParameters,
                                                .isRandom = true,
                                                .fillsOutline = true};

Status UniformScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Polygon filled = ScatterArea::domain(context.scatterOutline(), domain);
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(filled);
    if (!area) return area.error();
    const std::size_t first = seeds.size();
    if (const Status done = scatter(*wanted, *area, context, seeds); !done) return done;
    return followOutline(context, first, domain, seeds);
}

Status UniformScatter::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const SolidScatterDomain filled{context.domain, domain};
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled.volume(), context, seeds);
    if (!wanted) return wanted.error();
    return scatter(*wanted, filled, context, seeds);
}

double UniformScatter::estimatedPiecesIn(const SolidDomain& solid) const {
    return count.in(SolidScatterDomain{solid, domain}.volume(), SeedSpace::Solid);
}

}  // namespace rubble
