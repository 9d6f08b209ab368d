#include "core/fracture/DensityArea.h"
#include "core/fracture/PatternKind.h"

namespace rubble {
namespace {

constexpr std::array<ParameterChoice, 2> kDense{{{"bright", "Where it is bright"}, {"dark", "Where it is dark"}}};

constexpr std::array kParameters{
    parameter<&DensityImage::count>(kCountParameter),
    parameter<&DensityImage::dense>({.name = "dense",
                                     .caption = "Dense",
                                     .hint = "Where the picture has most seeds; where it is transparent it has none",
                                     .choices = kDense}),
};

Report noDensity(DenseWhere dense, const LayerContext& context, std::uint32_t wanted) {
    const std::string where = dense == DenseWhere::Bright ? "black" : "white";
    return {ReportCode::NoRoom, kNone, context.layer.id, 0.0,
            context.name() + " found room for 0 of " + std::to_string(wanted) + " seeds: its picture is " + where +
                " or transparent wherever the outline is."};
}

}  // namespace

constinit const PatternKind DensityImage::kKind{
    .name = "densityImage",
    .caption = "Density image",
    .hint = "Seeds that follow a grey picture",
    .role = LayerRole::Scatters,
    .parameters = kParameters,
    .suitedTo = [](const Box2&) -> LayerParameters { return DensityImage{}; }};

bool DensityImage::operator==(const DensityImage& other) const {
    const bool isSame = image == other.image || (image && other.image && *image == *other.image);
    return isSame && count == other.count && dense == other.dense;
}

std::optional<std::string> DensityImage::fault() const { return image ? verifyGreyImage(*image) : std::nullopt; }

Status DensityImage::apply(const LayerContext& context, SeedSet& seeds) const {
    if (!image) return success();
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.outline, context, seeds);
    if (!wanted) return wanted.error();
    const Result<DensityArea> area = DensityArea::of(context.outline, *image, dense, context.task);
    if (!area) return area.error();
    if (area->isEmpty()) {
        if (*wanted > 0) seeds.reports.push_back(noDensity(dense, context, *wanted));
        return success();
    }
    return scatter(*wanted, *area, context, seeds);
}

}  // namespace rubble
