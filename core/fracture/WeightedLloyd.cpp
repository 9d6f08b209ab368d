#include "core/fracture/WeightedLloyd.h"

#include "core/fracture/DensityArea.h"
#include "core/fracture/FalloffArea.h"
#include "core/fracture/PatternKind.h"
#include "core/fracture/Relaxation.h"
#include "core/geometry/ConvexParts.h"

#include <glm/geometric.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr int kPartsOfSide = 6;  // each triangle of a cell is weighed at the middles of so many squared

constexpr std::array kParameters{
    parameter<&WeightedLloyd::rounds>(
        {.name = "rounds",
         .caption = "Rounds",
         .hint = "How often seeds move to the middle of their cells, each place of them weighed by the "
                 "pictures and impacts above",
         .range = {0.0, kMostRelaxationRounds},
         .usual = {0.0, 50.0}}),
};

/// How many seeds the layers before want at a place, up to a factor.
class WishedDensity {
public:
    WishedDensity(const LayerContext& context) : m_box(boundsOf(context.outline.outer)) {
        for (const PatternLayer& layer : context.before) {
            if (!layer.isOn) continue;
            const auto* image = std::get_if<DensityImage>(&layer.parameters);
            const auto* impact = std::get_if<ImpactScatter>(&layer.parameters);
            if (image && image->image) m_images.push_back(image);
            if (impact) m_falloffs.push_back({impact->centre, impact->radius, impact->falloff});
        }
    }
    /// Between nothing, at which no cell could have a middle, and the number of layers.
    double at(Vec2 point) const {
        constexpr double kLeast = 1e-3;
        double sum = kLeast;
        for (const DensityImage* layer : m_images)
            sum += densityAt(*layer->image, layer->dense, (point - m_box.min) / m_box.size());
        for (const Falloff& falloff : m_falloffs) sum += falloff.at(glm::distance(point, falloff.centre));
        return sum;
    }

private:
    Box2 m_box;
    std::vector<const DensityImage*> m_images;
    std::vector<Falloff> m_falloffs;
};

/// Sums of weights and of weighed places.
struct WeighedCell {
    Vec2 moment{0.0, 0.0};
    double weight = 0.0;
};

/// Weighs a triangle at the middles of small ones, all of one size.
void weigh(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, const WishedDensity& density, WeighedCell& cell) {
    const Vec2 first = (b - a) / static_cast<double>(kPartsOfSide),
               second = (c - a) / static_cast<double>(kPartsOfSide);
    const double size = cross(first, second) / 2.0;
    const auto add = [&](double u, double v) {
        const Vec2 point = a + u * first + v * second;
        const double wished = density.at(origin + point), weight = wished * wished * size;
        cell.weight += weight;
        cell.moment += weight * point;
    };
    for (int i = 0; i < kPartsOfSide; ++i) {
        for (int j = 0; i + j < kPartsOfSide; ++j) {
            add(i + 1.0 / 3.0, j + 1.0 / 3.0);
            if (i + j + 1 < kPartsOfSide) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
        }
    }
}

/// The middle of all pieces of a seed, which begin at `piece`; `otherwise` where they weigh nothing.
Vec2 middleOfCell(const Partition& partition, std::uint32_t piece, const WishedDensity& density, Vec2 otherwise) {
    const std::uint32_t seed = partition.seedOfPiece[piece];
    WeighedCell cell;
    for (; piece < partition.pieceCount() && partition.seedOfPiece[piece] == seed; ++piece) {
        const Polygon outline = pieceOutline(partition, piece);
        std::vector<Vec2> corners = outline.outer;
        for (const Ring& hole : outline.holes) corners.insert(corners.end(), hole.begin(), hole.end());
        const Result<IndexLoops> parts = triangles(outline);
        if (!parts) continue;
        for (const std::vector<std::uint32_t>& part : *parts)
            weigh(corners[part[0]], corners[part[1]], corners[part[2]], partition.origin, density, cell);
    }
    return cell.weight > 0.0 ? partition.origin + cell.moment / cell.weight : otherwise;
}

}  // namespace

constinit const PatternKind WeightedLloyd::kKind{
    .name = "weightedLloyd",
    .caption = "Weighted relaxation",
    .hint = "Evens out the layers above, denser where their pictures and impacts are",
    .role = LayerRole::Moves,
    .parameters = kParameters,
    .suitedTo = [](const Box2&) -> LayerParameters { return WeightedLloyd{}; }};

Status WeightedLloyd::apply(const LayerContext& context, SeedSet& seeds) const {
    const WishedDensity density(context);
    return relax(rounds, context, seeds, [&](const Partition& partition, std::uint32_t piece, Vec2 seed) {
        return middleOfCell(partition, piece, density, seed);
    });
}

}  // namespace rubble
