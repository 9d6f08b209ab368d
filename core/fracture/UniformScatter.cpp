#include "core/fracture/PatternKind.h"
#include "core/fracture/ScatterArea.h"

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
    .hint = "Seeds anywhere, at random",
    .role = LayerRole::Scatters,
    .parameters = kParameters,
    .suitedTo = [](const Box2&) -> LayerParameters { return UniformScatter{}; }};

Status UniformScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Polygon filled = ScatterArea::domain(context.outline, domain);
    const Result<std::uint32_t> wanted = seedsToAdd(count, filled, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(filled);
    if (!area) return area.error();
    return scatter(*wanted, *area, context, seeds);
}

}  // namespace rubble
