// Tests core/fracture/pattern/PatternKind.cpp and core/fracture/pattern/PieceEstimate.cpp with all kinds of layers in
// core/fracture/kinds/, with core/fracture/layer/LayerParameter.cpp.
#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/kinds/BrickCourses.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "core/fracture/pattern/PieceEstimate.h"
#include "core/geometry/polygon/HalfPlaneClip.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/fracture/VerifiedPartition.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <set>

using namespace rubble;

namespace {

constexpr std::uint64_t kRandomSeeds = 1000;

/// A ring of `count` corners around the origin, between two radii.
Ring ringAround(int corners, double least, double most, Random& random) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners, radius = random.between(least, most);
        ring.push_back(radius * Vec2(cosine(angle), sine(angle)));
    }
    return ring;
}

/// Convex, concave, and concave with a hole, by turns.
Polygon randomOutline(std::uint64_t randomSeed) {
    Random random(randomSeed);
    const int corners = 3 + static_cast<int>(random.below(9));
    switch (randomSeed % 3) {
        case 0: return {ringAround(corners, 1.0, 1.0, random), {}};
        case 1: return {ringAround(corners + 3, 0.3, 1.2, random), {}};
        default: return {ringAround(corners + 3, 0.7, 1.2, random), {reversed(ringAround(corners, 0.1, 0.3, random))}};
    }
}

Pattern patternOf(const LayerParameters& parameters, std::uint64_t randomSeed) {
    return {{{.id = 1, .randomSeed = randomSeed, .parameters = UniformScatter{.count = 2}},
             {.id = 2, .randomSeed = randomSeed, .parameters = parameters}}};
}

/// The area of an outline within a box, by clipping its rings.
double areaWithin(const Polygon& outline, Vec2 min, Vec2 max) {
    const auto clippedArea = [&](Ring ring) {
        for (const HalfPlane& side : {HalfPlane{{-1.0, 0.0}, -min.x}, HalfPlane{{1.0, 0.0}, max.x},
                                      HalfPlane{{0.0, -1.0}, -min.y}, HalfPlane{{0.0, 1.0}, max.y}}) {
            Ring clipped;
            clipByHalfPlane(ring, side, clipped);
            ring.swap(clipped);
        }
        return ring.size() < 3 ? 0.0 : signedArea(ring);
    };
    double sum = clippedArea(outline.outer);
    for (const Ring& hole : outline.holes) sum += clippedArea(hole);
    return sum;
}

/// The cells of a bond from first principles: course by course, brick by brick.
Box2 cellOfBrick(const BrickBond& bond, int course, int column) {
    const double stretcher = bond.length + bond.mortar, header = bond.width + bond.mortar;
    const bool isOdd = course % 2 != 0;
    std::vector<double> bricks;  // lengths, repeated along the course
    double start = 0.0;          // of brick 0
    switch (bond.bond) {
        case BondKind::Stretcher: bricks = {stretcher}, start = isOdd ? stretcher / 2.0 : 0.0; break;
        case BondKind::Stack: bricks = {stretcher}; break;
        case BondKind::Header: bricks = {header}, start = isOdd ? header / 2.0 : 0.0; break;
        case BondKind::English: bricks = {isOdd ? header : stretcher}, start = isOdd ? header / 2.0 : 0.0; break;
        case BondKind::Flemish: bricks = {stretcher, header}, start = isOdd ? (stretcher + header) / 2.0 : 0.0; break;
    }
    const int count = static_cast<int>(bricks.size());
    const auto brickAt = [&](int k) { return bricks[static_cast<std::size_t>(((k % count) + count) % count)]; };
    double left = bond.origin.x + start;
    for (int k = 0; k < column; ++k) left += brickAt(k);
    for (int k = -1; k >= column; --k) left -= brickAt(k);
    const double rise = bond.height + bond.mortar, bottom = bond.origin.y + course * rise;
    return {{left, bottom}, {left + brickAt(column), bottom + rise}};
}

/// Verifies that each cell of a bond covers as much of the outline as its pieces.
QString brickFault(const Partition& partition, const Polygon& outline, const BrickBond& bond) {
    std::map<std::uint32_t, double> areas;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece)
        areas[partition.cutCellsOf(piece)[0]] += pieceArea(partition, piece);
    constexpr int kFar = 30;
    std::size_t found = 0;
    for (int course = -kFar; course <= kFar; ++course) {
        for (int column = -kFar; column <= kFar; ++column) {
            const Box2 cell = cellOfBrick(bond, course, column);
            const double expected = areaWithin(outline, cell.min, cell.max);
            const auto has = areas.find(BrickCourses::cellIndex(course, column));
            const double area = has == areas.end() ? 0.0 : has->second;
            if (std::abs(area - expected) > 1e-9)
                return QString("course %1, column %2: %3 m², not %4").arg(course).arg(column).arg(area).arg(expected);
            found += has != areas.end();
        }
    }
    return found == areas.size() ? QString() : "Some bricks are too far away.";
}

/// Verifies that no piece lies on both sides of a slice.
QString sliceFault(const Partition& partition, const CutSet& cuts) {
    for (const CutEdge& cut : cuts.edges) {
        const Vec2 from = cuts.points[cut.from], direction = glm::normalize(cuts.points[cut.to] - from);
        for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
            double least = 0.0, most = 0.0;
            forEachEdge(partition, piece, [&](std::uint32_t point, std::uint32_t, std::uint32_t) {
                const double side = cross(direction, partition.points[point] + partition.origin - from);
                least = std::min(least, side);
                most = std::max(most, side);
            });
            if (least < -1e-9 && most > 1e-9)
                return QString("Piece %1 lies on both sides of cut %2.").arg(piece).arg(cut.line);
        }
    }
    return {};
}

/// Verifies that every crack line runs along the edges of pieces or is reported as loose.
QString crackLineFault(const PatternStages& stages, const Polygon& outline, const CutSet& cuts) {
    const Partition& partition = stages.partition;
    double loose = 0.0, inside = 0.0, missed = 0.0;
    for (const Diagnostic& report : partition.diagnostics)
        loose += report.code == DiagnosticCode::LooseCut ? report.value : 0.0;
    constexpr int kSamples = 400;
    for (const CutEdge& cut : cuts.edges) {
        const Vec2 from = cuts.points[cut.from], along = cuts.points[cut.to] - from;
        for (int k = 0; k < kSamples; ++k) {
            const Vec2 place = from + along * ((k + 0.5) / kSamples);
            if (containment(outline, place) == Containment::Outside) continue;
            double nearest = 1.0;
            for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
                forEachEdge(partition, piece, [&](std::uint32_t a, std::uint32_t b, std::uint32_t) {
                    const Vec2 start = partition.points[a] + partition.origin,
                               edge = partition.points[b] - partition.points[a];
                    const double fraction = std::clamp(glm::dot(place - start, edge) / glm::dot(edge, edge), 0.0, 1.0);
                    nearest = std::min(nearest, glm::distance(place, start + fraction * edge));
                });
            }
            inside += glm::length(along) / kSamples;
            missed += nearest > 1e-9 ? glm::length(along) / kSamples : 0.0;
        }
    }
    const bool isAllThere = std::abs(missed - loose) <= 0.02 * inside;
    return isAllThere ? QString() : QString("%1 m of cuts are missing, %2 m reported").arg(missed).arg(loose);
}

/// The first fault of the pieces of a pattern on an outline; empty if there is none.
QString faultOn(const Polygon& outline, const Pattern& pattern) {
    const Result<PatternStages> stages = verifiedStages(pattern, outline);
    if (!stages) return QString::fromStdString(stages.error().message);
    const std::vector<SeedId>& ids = stages->seeds.ids;
    if (!std::ranges::is_sorted(ids)) return "The seeds are not in the order of their ids.";
    if (std::ranges::adjacent_find(ids) != ids.end()) return "Two seeds have one id.";
    const Partition& partition = stages->partition;
    double sum = 0.0;
    std::set<std::string> names;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        sum += pieceArea(partition, piece);
        if (!names.insert(pieceName(partition, piece, ids)).second) return "Two pieces have one name.";
    }
    if (std::abs(sum - area(outline)) > 1e-9 * area(outline)) return "Area is lost.";
    const LayerParameters& last = pattern.layers.back().parameters;
    if (const auto* bond = std::get_if<BrickBond>(&last)) return brickFault(partition, outline, *bond);
    const CutSet cuts = cutsOf(pattern, outline).value();
    if (std::holds_alternative<Slices>(last)) return sliceFault(partition, cuts);
    if (std::holds_alternative<CrackLines>(last)) return crackLineFault(*stages, outline, cuts);
    return {};
}

std::string faultOfLayer(const LayerParameters& parameters) {
    return verifyPattern({{{.id = 4, .parameters = parameters}}}).value_or("");
}

}  // namespace

class LayerParametersTest : public QObject {
    Q_OBJECT
private slots:
    void samplesCoverEveryKind() {
        std::set<std::size_t> tried;
        for (const LayerParameters& sample : patternSamples()) tried.insert(sample.index());
        QCOMPARE(tried.size(), patternKinds().size());
    }
    void everyKindFracturesRandomOutlines() {
        qInfo("random seeds 0 to %d", static_cast<int>(kRandomSeeds) - 1);
        const std::vector<LayerParameters> samples = patternSamples();
        for (std::uint64_t randomSeed = 0; randomSeed < kRandomSeeds; ++randomSeed) {
            const Polygon outline = randomOutline(randomSeed);
            for (std::size_t k = 0; k < samples.size(); ++k) {
                const QString fault = faultOn(outline, patternOf(samples[k], randomSeed));
                QVERIFY2(fault.isEmpty(), qPrintable(QString("random seed %1, sample %2 (%3): %4")
                                                         .arg(randomSeed)
                                                         .arg(k)
                                                         .arg(kindOf(samples[k]).caption, fault)));
            }
        }
    }
    void seedsOutsideTheOutlineAreOmitted() {
        for (const LayerParameters& sample : patternSamples()) {
            const auto* grid = std::get_if<JitteredGrid>(&sample);
            const auto* uniform = std::get_if<UniformScatter>(&sample);
            const bool mayLeave = kindOf(sample).role != LayerRole::Scatters ||
                                  (grid && grid->domain == ScatterDomain::BoundingBox) ||
                                  (uniform && uniform->domain == ScatterDomain::BoundingBox);
            for (std::uint64_t randomSeed = 0; randomSeed < 30 && !mayLeave; ++randomSeed) {
                const Polygon outline = randomOutline(randomSeed);
                const Seeds seeds = seedsOf(patternOf(sample, randomSeed), outline).value();
                for (const Vec2 seed : seeds.positions) {
                    QVERIFY2(containment(outline, seed) != Containment::Outside, kindOf(sample).caption);
                }
            }
        }
    }
    void defaultsSuitOutlinesOfAnySize() {
        for (const Polygon& outline : {unitSquare(), Polygon{rectangle({-1e-3, 0.0}, {1e-3, 5e-4}), {}},
                                       Polygon{rectangle({100.0, 50.0}, {400.0, 51.0}), {}}}) {
            for (const PatternKind* kind : patternKinds()) {
                const LayerParameters parameters = kind->defaultsFor(boundsOf(outline.outer));
                QVERIFY(&kindOf(parameters) == kind);
                QCOMPARE(faultOfLayer(parameters), std::string());
                const Result<Seeds> seeds = seedsOf({{{.id = 1, .randomSeed = 1, .parameters = parameters}}}, outline);
                QVERIFY2(seeds, kind->caption);
                const bool isEmpty =
                    kind->role != LayerRole::Scatters || std::holds_alternative<DensityImage>(parameters);
                QVERIFY2(patternStages({{{.id = 1, .randomSeed = 1, .parameters = parameters}}}, outline),
                         kind->caption);
                QVERIFY2(isEmpty == seeds->positions.empty(), kind->caption);
                QVERIFY2(seeds->positions.size() < 300, kind->caption);
            }
        }
    }
    void seedsOfEveryKindAreEstimated() {
        const Polygon outline = unitSquare();
        for (const PatternKind* kind : patternKinds()) {
            const Pattern pattern{
                {{.id = 1, .randomSeed = 1, .parameters = kind->defaultsFor(boundsOf(outline.outer))}}};
            const std::size_t seeds = seedsOf(pattern, outline).value().positions.size();
            const double estimate = estimatedPieces(pattern, 1.0);
            QVERIFY2(seeds == 0 || (estimate > 0.5 * static_cast<double>(seeds) &&
                                    estimate < 2.0 * static_cast<double>(seeds) + 1.0),
                     kind->caption);
        }
    }
    void cancelledLayersStop() {
        TaskContext task;
        task.cancel.cancel();
        for (const LayerParameters& sample : patternSamples()) {
            const auto* image = std::get_if<DensityImage>(&sample);
            if (std::holds_alternative<PlacedSeeds>(sample) || (image && !image->image)) continue;
            if (std::holds_alternative<Grain>(sample)) continue;
            const PatternLayer layer{.id = 1, .parameters = sample};
            const Polygon outline = unitSquare();
            SeedSet seeds;
            CutSet cuts;
            seeds.add({0, 0}, {0.5, 0.5}, false);
            const Status applied = std::visit(
                [&](const auto& parameters) -> Status {
                    const LayerContext context{{layer.id, layer.randomSeed, layer.overrides, task}, outline};
                    if constexpr (requires { parameters.apply(context, seeds); })
                        return parameters.apply(context, seeds);
                    if constexpr (requires { parameters.cut(context, cuts); }) return parameters.cut(context, cuts);
                    return success();
                },
                sample);
            QVERIFY2(!applied && applied.error().code == ErrorCode::Cancelled, kindOf(sample).caption);
        }
    }
    void parametersOutsideTheirRangeAreRejected() {
        for (const LayerParameters& sample : patternSamples()) {
            QCOMPARE(faultOfLayer(sample), std::string());
            for (const LayerParameter& parameter : kindOf(sample).parameters) {
                const bool isReal = parameter.type == ParameterType::Real;
                const double infinity = std::numeric_limits<double>::infinity();
                for (const double value : {parameter.range.min - 1.0, parameter.range.max + 1.0, infinity, -infinity,
                                           std::numeric_limits<double>::quiet_NaN()}) {
                    LayerParameters changed = sample;
                    if (!isReal || parameter.range.contains(value)) continue;
                    parameter.write(changed, value);
                    const std::string fault = faultOfLayer(changed);
                    QVERIFY2(fault.starts_with("Layer 4: \"" + std::string(parameter.caption)), fault.c_str());
                }
            }
        }
    }
    void parametersReadBackAsWritten() {
        for (const LayerParameters& sample : patternSamples()) {
            const PatternKind& kind = kindOf(sample);
            LayerParameters copy = kind.defaultsFor({{0.0, 0.0}, {3.0, 2.0}});
            for (const LayerParameter& parameter : kind.parameters) parameter.write(copy, parameter.read(sample));
            if (auto* placed = std::get_if<PlacedSeeds>(&copy)) *placed = std::get<PlacedSeeds>(sample);
            if (auto* density = std::get_if<DensityImage>(&copy)) density->image = std::get<DensityImage>(sample).image;
            if (auto* crackLines = std::get_if<CrackLines>(&copy)) *crackLines = std::get<CrackLines>(sample);
            QVERIFY2(copy == sample, kind.caption);
        }
    }
    void namesAndCaptionsAreNotEmptyAndUnique() {
        std::set<std::string_view> names;
        for (const PatternKind* kind : patternKinds()) {
            QVERIFY(names.insert(kind->name).second);
            QVERIFY(*kind->caption && *kind->hint);
            std::set<std::string_view> ofKind;
            for (const LayerParameter& parameter : kind->parameters) {
                QVERIFY(ofKind.insert(parameter.name).second && *parameter.caption && *parameter.hint);
                QCOMPARE(parameter.type == ParameterType::Option, !parameter.options.empty());
            }
        }
    }
};

RUBBLE_TEST(LayerParametersTest)
#include "LayerParametersTest.moc"
