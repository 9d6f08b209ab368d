// Tests the kinds of layers in core/fracture/kinds/ in closed meshes, with core/fracture/sampling/SolidVoidCells.cpp,
// core/fracture/sampling/PointNear.cpp, core/fracture/sampling/PairIndex.h and core/fracture/pattern/PieceEstimate.cpp.
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/pattern/PieceEstimate.h"
#include "core/fracture/pattern/SolidPatternCut.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/fracture/SolidSeeds.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

/// A kind with the parameters of a new layer in a mesh.
LayerParameters defaultsIn(const PatternKind& kind, const SolidDomain& domain) {
    LayerParameters parameters = kind.defaultsFor(domain.bounds());
    if (auto* image = std::get_if<DensityImage>(&parameters)) image->image = fourPixels();
    return parameters;
}

std::vector<const PatternKind*> scatteringKinds() {
    std::vector<const PatternKind*> kinds;
    for (const PatternKind* kind : patternKinds()) {
        if (kind->isSpatial && kind->role == LayerRole::Scatters) kinds.push_back(kind);
    }
    return kinds;
}

double minimumDistance(const std::vector<Vec3>& points) {
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < points.size(); ++k) {
        for (std::size_t other = 0; other < k; ++other)
            least = std::min(least, glm::distance(points[k], points[other]));
    }
    return least;
}

SolidDomain unitCube() { return domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1})); }

/// Verifies that seeds of the smaller layer are those of the larger one.
QString growthFault(const LayerParameters& few, const LayerParameters& many, const SolidDomain& domain) {
    const auto before = placesByIndex(layerSeedsIn(few, domain).value()),
               after = placesByIndex(layerSeedsIn(many, domain).value());
    if (after.size() <= before.size()) return "no seed was added";
    for (const auto& [index, place] : before) {
        const auto found = after.find(index);
        if (found == after.end() || found->second != place) return QString("seed %1 is not kept").arg(index);
    }
    return {};
}

SolidPartition cellsOf(const LayerParameters& parameters, const TriangleMesh& mesh) {
    return cutSolid(mesh, positionsOf(layerSeedsIn(parameters, domainOf(mesh)).value())).value();
}

}  // namespace

class SolidKindsTest : public QObject {
    Q_OBJECT
private slots:
    void kindsThatNeedAPlane() {
        std::set<std::string_view> names;
        for (const PatternKind* kind : patternKinds()) {
            if (!kind->isSpatial) names.insert(kind->name);
        }
        QCOMPARE(names, (std::set<std::string_view>{"strokes", "weightedLloyd", "radialCracks"}));
    }
    void newLayersFillMeshesOfAllShapes() {
        for (const auto& [name, mesh] : solidShapes()) {
            const SolidDomain domain = domainOf(mesh);
            for (const PatternKind* kind : scatteringKinds()) {
                const LayerParameters parameters = defaultsIn(*kind, domain);
                const Result<Seeds> seeds = layerSeedsIn(parameters, domain);
                const std::string what = std::string(name) + ", " + kind->caption;
                QVERIFY2(seeds, (what + ": " + errorText(seeds)).c_str());
                QVERIFY2(std::ranges::is_sorted(seeds->ids) && seeds->heights.size() == seeds->ids.size(),
                         what.c_str());
                for (const Vec3 seed : positionsOf(*seeds)) QVERIFY2(domain.contains(seed), what.c_str());
                QVERIFY2(seeds->ids.size() < 1500, (what + std::to_string(seeds->ids.size())).c_str());
                const bool isLattice =
                    kind->name == "jitteredGrid" || kind->name == "hexagonal" || kind->name == "radial";
                QVERIFY2(isLattice || !seeds->ids.empty(), what.c_str());
                QCOMPARE(positionsOf(*layerSeedsIn(parameters, domain)), positionsOf(*seeds));
            }
        }
    }
    void seedsAreEstimated() {
        for (const TriangleMesh& mesh :
             {boxMeshOf({0, 0, 0}, {1, 1, 1}), boxMeshOf({0, 0, 0}, {4, 2, 0.3}), bumpySphere(16)}) {
            const SolidDomain domain = domainOf(mesh);
            for (const PatternKind* kind : patternKinds()) {
                if (!kind->isSpatial) continue;
                const Pattern pattern{{{.id = 1, .randomSeed = 1, .parameters = defaultsIn(*kind, domain)}}};
                const double found = static_cast<double>(seedsOf(pattern, domain)->ids.size());
                const double estimate = estimatedPieces(pattern, domain);
                const std::string what =
                    std::string(kind->caption) + ": " + std::to_string(estimate) + ", found " + std::to_string(found);
                QVERIFY2(found == 0.0 || (estimate > 0.5 * found && estimate < 3.5 * found + 1.0), what.c_str());
            }
        }
    }
    void cancelledLayersStop() {
        TaskContext task;
        task.cancel.cancel();
        const SolidDomain domain = unitCube();
        for (const LayerParameters& sample : patternSamples()) {
            const auto* image = std::get_if<DensityImage>(&sample);
            if (std::holds_alternative<PlacedSeeds>(sample) || (image && !image->image)) continue;
            SeedSet seeds;
            seeds.add({0, 0}, Vec3(0.5), false);
            const Status applied = std::visit(
                [&](const auto& parameters) -> Status {
                    const SolidLayerContext context{{1, 0, {}, task}, domain};
                    if constexpr (requires { parameters.applyInSolid(context, seeds); })
                        return parameters.applyInSolid(context, seeds);
                    return TaskContext::cancelled();
                },
                sample);
            QVERIFY2(!applied && applied.error().code == ErrorCode::Cancelled, kindOf(sample).caption);
        }
    }
    void growthKeepsSeeds() {
        const SolidDomain domain = domainOf(torus(24, 16));
        const std::vector<std::pair<LayerParameters, LayerParameters>> grown{
            {UniformScatter{.count = 10}, UniformScatter{.count = 30}},
            {BlueNoise{.minimumDistance = 0.2, .count = 10}, BlueNoise{.minimumDistance = 0.2, .count = 30}},
            {Clusters{.clusters = 3, .seedsPerCluster = 4}, Clusters{.clusters = 5, .seedsPerCluster = 4}},
            {Clusters{.clusters = 3, .seedsPerCluster = 4}, Clusters{.clusters = 3, .seedsPerCluster = 7}},
            {ImpactScatter{.count = 10}, ImpactScatter{.count = 30}},
            {SurfaceScatter{.count = 10}, SurfaceScatter{.count = 30}},
            {DensityImage{.count = 10, .image = fourPixels()}, DensityImage{.count = 30, .image = fourPixels()}},
            {RadialPattern{.radius = 1.4, .layers = 2}, RadialPattern{.radius = 1.4, .layers = 4}},
            {HexagonalLattice{.layerHeight = 0.2},
             HexagonalLattice{.domain = ScatterDomain::BoundingBox, .layerHeight = 0.2}},
        };
        for (const auto& [few, many] : grown) {
            const QString fault = growthFault(few, many, domain);
            QVERIFY2(fault.isEmpty(), qPrintable(QString(kindOf(few).caption) + ": " + fault));
        }
    }
    void tripleIndicesAreDistinctInGrowingCubes() {
        std::set<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < 9; ++i) {
            for (std::uint32_t j = 0; j < 9; ++j) {
                for (std::uint32_t k = 0; k < 9; ++k) {
                    const std::uint32_t index = tripleIndex(i, j, k), side = std::max({i, j, k});
                    QVERIFY(index >= side * side * side && index < (side + 1) * (side + 1) * (side + 1));
                    seen.insert(index);
                }
            }
        }
        QCOMPARE(seen.size(), std::size_t{729});
        QCOMPARE(tripleIndex(1599, 1599, 1598), 4'095'999'999u);
        for (const std::uint32_t number : {0u, 1u, 2u, 7u}) QCOMPARE(zigzag(zigzagged(number)), number);
    }
    void blueNoiseFillsTheMeshAtItsDistance() {
        const SolidDomain cube = unitCube();
        const std::vector<Vec3> seeds = positionsOf(layerSeedsIn(BlueNoise{.minimumDistance = 0.2}, cube).value());
        QVERIFY(minimumDistance(seeds) >= 0.2);
        Random random(4);
        double farthest = 0.0;  // maximal: no point is farther from all seeds than the distance, but for tiny gaps
        for (int k = 0; k < 20'000; ++k) {
            const Vec3 point = cube.point(random);
            double nearest = HUGE_VAL;
            for (const Vec3 seed : seeds) nearest = std::min(nearest, glm::distance(seed, point));
            farthest = std::max(farthest, nearest);
        }
        QVERIFY2(farthest < 0.21, std::to_string(farthest).c_str());
    }
    void blueNoiseReportsTooManySeeds() {
        const Seeds seeds = layerSeedsIn(BlueNoise{.minimumDistance = 0.5, .count = 500}, unitCube()).value();
        QCOMPARE(seeds.diagnostics.size(), std::size_t{1});
        QCOMPARE(seeds.diagnostics[0].code, DiagnosticCode::NoRoom);
        QCOMPARE(errorText(layerSeedsIn(BlueNoise{.minimumDistance = 1e-4}, unitCube())),
                 "Layer 1 brings the pattern above 10000000 seeds.");
    }
    void clustersAreTightInThinMeshesToo() {
        const SolidDomain plate = domainOf(transformed(boxMeshOf({0, 0, 0}, {1, 1, 1e-4}), obliqueTurn()));
        const Seeds seeds = layerSeedsIn(Clusters{.clusters = 4, .seedsPerCluster = 30, .radius = 0.1}, plate).value();
        QCOMPARE(seeds.ids.size(), std::size_t{120});
        QVERIFY(seeds.diagnostics.empty());
        const auto places = placesByIndex(seeds);
        for (std::uint32_t cluster = 0; cluster < 4; ++cluster) {
            for (std::uint32_t k = 1; k < 30; ++k) {
                QVERIFY(glm::distance(places.at(pairIndex(cluster, 0)), places.at(pairIndex(cluster, k))) <= 0.2);
            }
        }
    }
    void halfOfACusterLiesWithinHalfItsRadius() {
        const SolidDomain cube = domainOf(boxMeshOf({-1000, -1000, -1000}, {1000, 1000, 1000}));
        const std::vector<Vec3> seeds =
            positionsOf(layerSeedsIn(Clusters{.clusters = 1, .seedsPerCluster = 2000, .radius = 1.0}, cube).value());
        Vec3 centre(0.0);
        for (const Vec3 seed : seeds) centre += seed / 2000.0;
        const auto within = std::ranges::count_if(seeds, [&](Vec3 seed) { return glm::distance(seed, centre) < 0.5; });
        QVERIFY2(std::abs(within - 1000) < 130, std::to_string(within).c_str());
    }
    void impactIsDenseAroundItsPoint() {
        const SolidDomain cube = unitCube();
        const ImpactScatter impact{
            .centre = {0.2, 0.3}, .count = 4000, .radius = 0.1, .falloff = 4.0, .centreHeight = 0.6};
        // The expected fraction within 0.1 of the centre, by integration of (1 + (d/r)^2)^-2 over uniform points.
        Random random(8);
        double within = 0.0, all = 0.0;
        for (int k = 0; k < 400'000; ++k) {
            const double x = random.unit(), y = random.unit(), z = random.unit();
            const double fraction = glm::distance(Vec3(x, y, z), Vec3(0.2, 0.3, 0.6)) / 0.1;
            const double density = 1.0 / ((1.0 + fraction * fraction) * (1.0 + fraction * fraction));
            all += density, within += fraction < 1.0 ? density : 0.0;
        }
        double found = 0.0;
        for (const Vec3 seed : positionsOf(layerSeedsIn(impact, cube).value()))
            found += glm::distance(seed, Vec3(0.2, 0.3, 0.6)) < 0.1;
        QVERIFY2(std::abs(found - 4000.0 * within / all) < 200.0, std::to_string(found).c_str());
    }
    void impactsOfAnySizeAndPlaceAreInside() {
        for (const auto& [name, mesh] : solidShapes()) {
            const SolidDomain domain = domainOf(mesh);
            const double size = domain.bounds().diagonal();
            const Vec3 centre = domain.bounds().centre();
            for (const double radius : {1e-9, 1e-3, 1.0}) {
                for (const double far : {0.0, 0.6, 1e3}) {
                    const ImpactScatter impact{.centre = Vec2(centre) + far * size,
                                               .count = 50,
                                               .radius = radius * size,
                                               .falloff = 8.0,
                                               .centreHeight = centre.z};
                    const std::vector<Vec3> seeds = positionsOf(layerSeedsIn(impact, domain).value());
                    const std::string what =
                        std::string(name) + " " + std::to_string(radius) + " " + std::to_string(far);
                    for (const Vec3 seed : seeds) QVERIFY2(domain.contains(seed), what.c_str());
                }
            }
        }
    }
    void ringsAreAroundTheAxis() {
        const SolidDomain cube = domainOf(boxMeshOf({-1, -1, -1}, {1, 1, 1}));
        for (const CoordinateAxis axis : {CoordinateAxis::X, CoordinateAxis::Y, CoordinateAxis::Z}) {
            const RadialPattern rings{.radius = 0.8,
                                      .rings = 4,
                                      .spokes = 6,
                                      .exponent = 1.0,
                                      .variation = 0.0,
                                      .axis = axis,
                                      .layers = 3,
                                      .layerSpacing = 0.5};
            const auto places = placesByIndex(layerSeedsIn(rings, cube).value());
            QCOMPARE(places.size(), std::size_t{75});
            const int along = static_cast<int>(axis);
            for (std::uint32_t layer = 0; layer < 3; ++layer) {
                Vec3 middle(0.0);
                middle[along] = 0.5 * zigzagged(layer);
                QCOMPARE(places.at(tripleIndex(0, 0, layer)), middle);
                for (std::uint32_t ring = 1; ring <= 4; ++ring) {
                    const Vec3 place = places.at(tripleIndex(ring, 2, layer));
                    QCOMPARE(place[along], middle[along]);
                    QVERIFY(std::abs(glm::distance(place, middle) - 0.2 * ring) < 1e-12);
                }
            }
        }
    }
    void slicesCutSlabs() {
        const TriangleMesh mesh = boxMeshOf({0, 0, 0}, {1, 2, 4});
        const Slices even{.cuts = 3, .angle = 0.0, .offsetVariation = 0.0, .angleVariation = 0.0, .tilt = kQuarter};
        const SolidPartition level = cellsOf(even, mesh);
        QCOMPARE(level.fragmentCount(), 4u);
        for (const double volume : level.volumes) QVERIFY(std::abs(volume - 2.0) < 1e-9);
        Slices upright = even;
        upright.tilt = 0.0;  // the cuts are along x: slabs follow each other along y
        const std::vector<Vec3> seeds = positionsOf(layerSeedsIn(upright, domainOf(mesh)).value());
        QVERIFY(glm::distance(seeds[0], Vec3(0.5, 1.75, 2.0)) < 1e-12 &&
                glm::distance(seeds[3], Vec3(0.5, 0.25, 2.0)) < 1e-12);
        const Slices varied{.cuts = 9, .angle = 0.6, .offsetVariation = 1.0, .angleVariation = 0.3, .tilt = 0.4};
        QVERIFY(cellsOf(varied, mesh).fragmentCount() >= 10);
    }
    void gridsAndColumnsCutEqualCells() {
        const TriangleMesh mesh = boxMeshOf({0, 0, 0}, {2, 3, 4});
        const SolidPartition grid = cellsOf(JitteredGrid{.columns = 2, .rows = 3, .jitter = 0.0, .layers = 4}, mesh);
        QCOMPARE(grid.fragmentCount(), 24u);
        for (const double volume : grid.volumes) QVERIFY(std::abs(volume - 1.0) < 1e-9);
        const SolidPartition sized = cellsOf(
            JitteredGrid{
                .cells = GridCells::Size, .cellWidth = 1.0, .cellHeight = 1.5, .jitter = 0.0, .cellDepth = 2.0},
            mesh);
        QCOMPARE(sized.fragmentCount(), 8u);
        const std::vector<Vec3> columns =
            positionsOf(layerSeedsIn(HexagonalLattice{.spacing = 0.5}, domainOf(mesh)).value());
        for (const Vec3 seed : columns) QCOMPARE(seed.z, 2.0);
        const std::vector<Vec3> layers =
            positionsOf(layerSeedsIn(HexagonalLattice{.spacing = 0.5, .layerHeight = 1.0}, domainOf(mesh)).value());
        QCOMPARE(layers.size(), 5 * columns.size());
        QVERIFY(std::abs(minimumDistance(layers) - 0.5) < 1e-12);
    }
    void bricksOfAStackBondAreBoxes() {
        const TriangleMesh mesh = boxMeshOf({0, 0, 0}, {1, 0.4, 0.4});
        const BrickBond stack{.bond = BondKind::Stack, .length = 0.24, .height = 0.09, .mortar = 0.01, .depth = 0.19};
        const SolidPartition bricks = cellsOf(stack, mesh);
        QCOMPARE(bricks.fragmentCount(), 32u);
        for (const double volume : bricks.volumes) QVERIFY(std::abs(volume - 0.005) < 1e-12);
        BrickBond stretcher = stack;
        stretcher.bond = BondKind::Stretcher;
        const auto places = placesByIndex(layerSeedsIn(stretcher, domainOf(mesh)).value());
        QVERIFY(glm::distance(places.at(tripleIndex(0, zigzag(1), 0)), Vec3(0.25, 0.15, 0.1)) <
                1e-12);  // half a brick on
        QVERIFY(glm::distance(places.at(tripleIndex(0, 0, zigzag(1))), Vec3(0.125, 0.05, 0.3)) < 1e-12);
        const std::string error = errorText(layerSeedsIn(BrickBond{.mortar = 0.0, .depth = 1e-5}, domainOf(mesh)));
        QVERIFY2(error.starts_with("Layer 1 has bricks more than 800 courses, columns or rows"), error.c_str());
    }
    void latticesThatAreTooFineAreRefused() {
        const SolidDomain cube = unitCube();
        QCOMPARE(errorText(layerSeedsIn(JitteredGrid{.columns = 2000}, cube)),
                 "Layer 1 has 2000 cells along one side, but 1600 is the maximum on a mesh.");
        QCOMPARE(errorText(layerSeedsIn(HexagonalLattice{.spacing = 0.5, .layerHeight = 1e-4}, cube)),
                 "Layer 1 has 10000 layers, but 1600 is the maximum on a mesh.");
        QCOMPARE(errorText(layerSeedsIn(RadialPattern{.rings = 1600}, cube)),
                 "Layer 1 has 1601 rings or spokes, but 1600 is the maximum on a mesh.");
        QVERIFY(!layerSeedsIn(HexagonalLattice{.spacing = 1e-4}, cube));
    }
    void relaxationEvensOutCells() {
        for (const TriangleMesh& mesh : {boxMeshOf({0, 0, 0}, {1, 1, 1}), torus(20, 12)}) {
            const SolidDomain domain = domainOf(mesh);
            Pattern pattern{{{.id = 1, .randomSeed = 3, .parameters = UniformScatter{.count = 40}},
                             {.id = 2, .parameters = PlacedSeeds{{{0, {0.5, 0.5}, 0.5}}}}}};
            const auto deviation = [&] {
                const SolidPartition cells = cutSolid(mesh, positionsOf(seedsOf(pattern, domain).value())).value();
                double sum = 0.0, squares = 0.0;
                for (const double volume : cells.volumes) sum += volume, squares += volume * volume;
                return squares * double(cells.fragmentCount()) / sum / sum - 1.0;
            };
            const double before = deviation();
            pattern.layers.push_back({.id = 3, .parameters = LloydRelaxation{.rounds = 10}});
            QVERIFY(deviation() < 0.3 * before);
            QCOMPARE(seedsOf(pattern, domain)->at(40), Vec3(0.5));
            TaskContext threads;
            threads.threads = 4;
            QCOMPARE(positionsOf(seedsOf(pattern, domain, threads).value()),
                     positionsOf(seedsOf(pattern, domain).value()));
        }
    }
    void relaxationFollowsTheGrain() {
        const SolidDomain cube = unitCube();
        Pattern pattern{{{.id = 1, .randomSeed = 3, .parameters = UniformScatter{.count = 20}},
                         {.id = 3, .parameters = LloydRelaxation{.rounds = 2}}}};
        const std::vector<Vec3> plain = positionsOf(seedsOf(pattern, cube).value());
        pattern.layers.push_back({.id = 4, .parameters = Grain{.ratio = 4.0}});
        QVERIFY(positionsOf(seedsOf(pattern, cube).value()) != plain);
    }
    void imageIsProjectedAlongZ() {
        const SolidDomain cube = unitCube();
        const auto image = std::make_shared<GreyImage>(
            GreyImage{.width = 2, .height = 1, .bits = 8, .grey = {0, 0xff}, .opacity = {}});
        for (const Vec3 seed : positionsOf(layerSeedsIn(DensityImage{.count = 500, .image = image}, cube).value()))
            QVERIFY(seed.x <= 0.5);
        const auto white =
            std::make_shared<GreyImage>(GreyImage{.width = 1, .height = 1, .bits = 8, .grey = {0xff}, .opacity = {}});
        QCOMPARE(layerSeedsIn(DensityImage{.image = white}, cube)->diagnostics[0].code, DiagnosticCode::NoRoom);
    }
};

RUBBLE_TEST(SolidKindsTest)
#include "SolidKindsTest.moc"
