// Tests viewport/scene/SceneBuilder.cpp, viewport/scene/AssetModel.cpp, viewport/scene/BodyColours.cpp,
// viewport/scene/BondLines.cpp, viewport/scene/SolidBuilder.cpp and viewport/scene/SceneGeometry.cpp.
#include "core/asset/library/StarterProject.h"
#include "core/asset/project/FragmentColours.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/structure/clusters/ClusterColours.h"
#include "tests/support/Closeness.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/files/TestImages.h"
#include "viewport/scene/SceneBuilder.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

AssetBakes allBakes(const Project& project) { return bakesOf(project).value(); }

/// The starter project's wall twice: as it is, and two metres to the right, rotated by 90° about y.
Project twoWalls() {
    Project project = starterProject();
    Instance second = project.instances[0];
    second.id = project.nextId++;
    second.name = "second";
    second.pose.position += Vec3(2.0, 0.0, 0.0);
    second.pose.orientation = Quat(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);
    project.instances.push_back(second);
    return project;
}

/// The largest difference of a channel of two packed colours.
int colourDistance(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16}) {
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 0xff) - static_cast<int>(b >> shift & 0xff)));
    }
    return most;
}

Project wallOf(std::uint32_t fragments) {
    Project project = starterProject();
    project.assets[0].pattern.layers = {
        {.id = project.nextId++, .randomSeed = 1, .parameters = UniformScatter{.count = fragments}}};
    project.instances.resize(1);
    return project;
}

/// The processor time for what a hundred moves of the explode slider, with all fragments selected, make of a scene, ms.
double sceneTime(std::uint32_t fragments) {
    const Project project = wallOf(fragments);
    const AssetBakes bakes = allBakes(project);
    SceneBuilder builder;
    SceneOptions options{.colouring = SceneColouring::Volume};
    const RenderScene first = builder.sceneOf(project, bakes, options);
    options.marks.selected = first.picks;
    const double start = test::processorTime();
    for (int k = 1; k <= 100; ++k) {
        options.explodeFactor = 0.01 * k;
        const RenderScene scene = builder.sceneOf(project, bakes, options);
        if (scene.batches != first.batches) qFatal("The geometry was built again.");
    }
    return test::processorTime() - start;
}

}  // namespace

class SceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void instancesShareGeometry() {
        const Project project = twoWalls();
        const RenderScene scene = sceneOf(project, allBakes(project));
        QCOMPARE(scene.batches.size(), std::size_t{1});
        QCOMPARE(scene.batches[0].firstBodies, (std::vector<std::uint32_t>{0, 20}));
        QCOMPARE(scene.batches[0].geometry->solidCount(), 20u);
        QCOMPARE(scene.poses.size(), std::size_t{40});
        QVERIFY((scene.picks[25] == PickId{project.assets[0].id, project.instances[1].id, 5}));
    }
    void instancesHaveTheirPoses() {
        const Project project = twoWalls();
        const Box3 bounds = boundsOf(sceneOf(project, allBakes(project)));
        const Vec3 first = project.instances[0].pose.position;
        QVERIFY(isWithinDistance(bounds.min, first - Vec3(0.5, 0.5, 0.5), 1e-6));
        QVERIFY(isWithinDistance(bounds.max, first + Vec3(2.25, 0.5, 0.5), 1e-6));
    }
    void keepsPrecisionFarFromTheOrigin() {
        Project project = starterProject();
        project.instances[0].pose.position = {1e7, 2e7, -1e7};
        const RenderScene scene = sceneOf(project, allBakes(project));
        QVERIFY(isWithinDistance(boundsOf(scene).max - boundsOf(scene).min, {1.0, 1.0, 0.5}, 1e-6));
    }
    void assetWithoutBakeIsWhole() {
        const Project project = starterProject();
        const RenderScene scene = sceneOf(project, {});
        QCOMPARE(scene.poses.size(), std::size_t{1});
        QCOMPARE(scene.picks[0].fragment, kNone);
        QVERIFY(isWithinDistance(boundsOf(scene).max - boundsOf(scene).min, {1.0, 1.0, 0.5}, 1e-6));
    }
    void invalidPrismIsLeftOut() {
        Project project = starterProject();
        std::swap(project.assets[0].prism().outline.outer[0], project.assets[0].prism().outline.outer[1]);
        QVERIFY(sceneOf(project, {}).batches.empty());
        QVERIFY(boundsOf(sceneOf(project, {})).isEmpty());
    }
    void explodeFactorScalesDistances() {
        const Project project = starterProject();
        const RenderScene together = sceneOf(project, allBakes(project));
        const RenderScene apart = sceneOf(project, allBakes(project), {.explodeFactor = 1.0});
        QVERIFY(together.batches[0].firstBodies == apart.batches[0].firstBodies);
        const Vec3 foot = boundsOf(together).centre() - Vec3(0.0, 0.5, 0.0);
        for (std::size_t k = 0; k < apart.poses.size(); ++k) {
            const Vec3 arm = together.origin + Vec3(together.poses[k].position) - foot;
            QVERIFY(isWithinDistance(Vec3(apart.explodeOffsets[k]), arm, 1e-6));
        }
        QVERIFY(boundsOf(apart).min.y > boundsOf(together).min.y - 1e-6);  // nothing goes below the ground
    }
    void volumeColouringSpansTheRange() {
        const Project project = starterProject();
        const AssetBakes bakes = allBakes(project);
        std::vector<double> volumes;
        for (std::uint32_t k = 0; k < 20; ++k) volumes.push_back(bakes.begin()->second->fragment(k).solid.volume());
        const auto [least, most] = std::ranges::minmax_element(volumes);
        const RenderScene scene = sceneOf(project, bakes, {.colouring = SceneColouring::Volume});
        QCOMPARE(scene.appearances[static_cast<std::size_t>(least - volumes.begin())].outside, packed(rampColour(0.0)));
        QCOMPARE(scene.appearances[static_cast<std::size_t>(most - volumes.begin())].outside, packed(rampColour(1.0)));
    }
    void everyQuantityHasItsRange() {
        Project project = starterProject();
        project.assets[0].levels = {
            {.pattern = {{{.id = 70, .parameters = UniformScatter{.count = 3}}}}, .minimumVolume = 0.02}};
        project.instances[0].threshold = 80.0;
        const AssetBakes bakes = allBakes(project);
        const Bake& bake = *bakes.begin()->second;
        const auto figureOf = [&](SceneColouring colouring, std::uint32_t number) {
            const BakedFragment fragment = bake.fragment(number);
            switch (colouring) {
                case SceneColouring::Level: return static_cast<double>(fragment.level);
                case SceneColouring::Mass: return fragment.solid.volume() * project.materials[0].density;
                case SceneColouring::Aspect: return fragment.solid.aspectRatio();
                case SceneColouring::Threshold: {
                    const double parent =
                        fragment.parent == kNone ? bake.whole.volume : bake.fragment(fragment.parent).solid.volume();
                    return 80.0 * std::pow(parent / bake.whole.volume, 2.0 / 3.0);
                }
                default: return fragment.solid.volume();
            }
        };
        for (const SceneColouring colouring : {SceneColouring::Level, SceneColouring::Volume, SceneColouring::Mass,
                                               SceneColouring::Aspect, SceneColouring::Threshold}) {
            const RenderScene scene = sceneOf(project, bakes, {.colouring = colouring});
            QVERIFY(scene.colourRange);
            ValueRange range{1e308, 0.0};
            for (const PickId& pick : scene.picks) {
                const double figure = figureOf(colouring, pick.fragment);
                range = {std::min(range.least, figure), std::max(range.most, figure)};
            }
            QVERIFY(std::abs(scene.colourRange->least - range.least) <= 1e-9 * range.least);
            QVERIFY(std::abs(scene.colourRange->most - range.most) <= 1e-9 * range.most);
            for (std::size_t body = 0; body < scene.picks.size(); ++body) {
                const double fraction =
                    (figureOf(colouring, scene.picks[body].fragment) - range.least) / (range.most - range.least);
                QVERIFY(colourDistance(scene.appearances[body].outside, packed(rampColour(fraction))) <=
                        1);  // rounding
            }
        }
        QVERIFY(!sceneOf(project, bakes, {.colouring = SceneColouring::Fragment}).colourRange);
    }
    /// Fragments have the threshold of what breaks into them.
    void thresholdColoursShowThresholdsThatAreSet() {
        Project project = starterProject();
        Asset& wall = project.assets[0];
        wall.levels = {{.pattern = {{{.id = 70, .parameters = UniformScatter{.count = 3}}}}, .threshold = 5.0}};
        const AssetBakes bakes = allBakes(project);
        const FragmentPath own = bakes.begin()->second->fragmentPath(0);
        wall.fragmentThresholds = {{own, 2.0}};
        wall.threshold = 90.0;
        const RenderScene scene = sceneOf(project, bakes, {.colouring = SceneColouring::Threshold});
        QCOMPARE(scene.colourRange->least, 2.0);
        QCOMPARE(scene.colourRange->most, 5.0);
        for (std::size_t body = 0; body < scene.picks.size(); ++body) {
            const bool isOwn = bakes.begin()->second->fragment(scene.picks[body].fragment).parent == 0;
            QCOMPARE(scene.appearances[body].outside, packed(rampColour(isOwn ? 0.0 : 1.0)));
        }
    }
    void clustersHaveColoursOfTheirOwn() {
        Project project = boxProject(UniformScatter{});
        project.assets = {test::clusteredRow({{0, {"3.0", "3.1"}}, {0, {"3.2", "3.3"}}})};
        const Asset& row = project.assets[0];
        const AssetBakes bakes = allBakes(project);
        RenderScene scene = sceneOf(project, bakes, {.colouring = SceneColouring::Cluster});
        const std::vector<Colour> colours = clusterColours(row, *bakes.begin()->second, 0);
        QCOMPARE(scene.picks.size(), std::size_t{8});
        for (std::size_t body = 0; body < 8; ++body)
            QCOMPARE(scene.appearances[body].outside, packed(colours[scene.picks[body].fragment]));
        QVERIFY(scene.appearances[0].outside != scene.appearances[2].outside && !scene.colourRange);
        project.assets[0].breakAs = BreakAs::Whole;
        scene = sceneOf(project, bakes, {.colouring = SceneColouring::Cluster});
        QCOMPARE(scene.appearances[0].outside, packed(kUnclusteredColour));
    }
    void bondLinesJoinCentres() {
        const Project project = starterProject();
        const AssetBakes bakes = allBakes(project);
        const Bake& bake = *bakes.begin()->second;
        std::size_t contacts = 0;
        double largest = 0.0;
        for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
            for (const FragmentContact& contact : bake.fragment(k).solid.contacts()) {
                ++contacts;
                largest = std::max(largest, contact.area);
            }
        }
        RenderScene scene = sceneOf(project, bakes, {.explodeFactor = 0.5, .hasBonds = true});
        QCOMPARE(scene.lines.size(), contacts / 2);
        QCOMPARE(scene.largestBondArea, largest);
        float widest = 0.0f;
        for (const SceneLine& line : scene.lines) {
            widest = std::max(widest, line.from.w);
            const auto isMiddle = [&](const glm::vec4& end) {
                for (std::uint32_t body = 0; body < scene.poses.size(); ++body) {
                    const Vec3 middle = Vec3(scene.poses[body].position) + explodeOffset(scene, body);
                    if (glm::distance(middle, Vec3(end)) < 1e-5) return true;
                }
                return false;
            };
            QVERIFY(isMiddle(line.from) && isMiddle(line.to));
        }
        QVERIFY(widest > 3.0f);
        const std::uint32_t touching = static_cast<std::uint32_t>(bake.fragment(0).solid.contacts().size());
        const RenderScene fewer =
            sceneOf(project, bakes, {.hasBonds = true, .marks = {.hidden = {{project.assets[0].id, 0, 0}}}});
        QCOMPARE(fewer.lines.size(), contacts / 2 - touching);
        QVERIFY(sceneOf(project, bakes, {}).lines.empty());
    }
    void fragmentColoursAreStable() {
        Project project = starterProject();
        const RenderScene few = sceneOf(project, allBakes(project), {.colouring = SceneColouring::Fragment});
        std::get<UniformScatter>(project.assets[0].pattern.layers[0].parameters).count = 30;
        const RenderScene more = sceneOf(project, allBakes(project), {.colouring = SceneColouring::Fragment});
        QCOMPARE(few.appearances[7].outside, more.appearances[7].outside);
        QVERIFY(few.appearances[7].outside != few.appearances[8].outside);
        QVERIFY(few.appearances[7].outside != few.appearances[7].inside);
    }
    void marksMatchOneOrManyBodies() {
        const Project project = twoWalls();
        RenderScene scene = sceneOf(project, allBakes(project));
        const Id asset = project.assets[0].id, second = project.instances[1].id;
        setMarks(scene,
                 {.hidden = {{asset, 0, 3}}, .selected = {{asset, second, kNone}}, .hovered = {{asset, second, 4}}});
        QCOMPARE(scene.appearances[3].marks, kHidden);
        QCOMPARE(scene.appearances[23].marks, kHidden | kSelected);
        QCOMPARE(scene.appearances[24].marks, kSelected | kHovered);
        QCOMPARE(scene.appearances[4].marks, 0u);
        QVERIFY(isWithinDistance(boundsOf(scene, kSelected).min,
                                 project.instances[1].pose.position - Vec3(0.25, 0.5, 0.5), 1e-6));
        setMarks(scene, {});
        QCOMPARE(scene.appearances[23].marks, 0u);
    }
    void unchangedGeometryIsShared() {
        const Project project = starterProject();
        AssetBakes bakes = allBakes(project);
        SceneBuilder builder;
        const RenderScene first = builder.sceneOf(project, bakes, {});
        const RenderScene apart = builder.sceneOf(project, bakes, {.explodeFactor = 1.0});
        QVERIFY(first.batches[0].geometry == apart.batches[0].geometry);
        Project other = project;
        other.assets[0].pattern.layers[0].randomSeed += 1;
        const RenderScene changed = builder.sceneOf(other, allBakes(other), {});
        QVERIFY(changed.batches[0].geometry != first.batches[0].geometry);
    }
    /// Triangles of a curved surface have no lines between them; its fragments do.
    void edgesOfCurvedSurfacesAreHidden() {
        Project project = test::meshProject();
        project.assets = {test::meshAsset(test::torus(64, 32), 6)};
        project.instances = {{.id = 60, .name = "torus", .asset = project.assets[0].id}};
        const auto edges = [](const RenderScene& scene) {
            return std::ranges::count_if(scene.batches[0].geometry->vertices, [](const SceneVertex& vertex) {
                return vertex.across[0] != 128 || vertex.across[1] != 128;
            });
        };
        QCOMPARE(edges(sceneOf(project, {})), 0);
        const RenderScene broken = sceneOf(project, allBakes(project));
        QVERIFY(edges(broken) > 0);
    }
    /// Lines fade where faces are narrow on the screen: the fine triangles of a curved surface are as wide as its
    /// fragments for that, so that cracks are seen from afar.
    void cracksOfFineMeshesAreAsWideAsTheirFragments() {
        Project project = test::meshProject();
        project.assets = {test::meshAsset(test::torus(64, 32), 6)};
        project.instances = {{.id = 60, .name = "torus", .asset = project.assets[0].id}};
        const RenderScene scene = sceneOf(project, allBakes(project));
        const SceneGeometry& geometry = *scene.batches[0].geometry;
        int fine = 0;
        for (std::size_t t = 0; t < geometry.indices.size(); t += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                const SceneVertex &a = geometry.vertices[geometry.indices[t + k]],
                                  &b = geometry.vertices[geometry.indices[t + (k + 1) % 3]],
                                  &c = geometry.vertices[geometry.indices[t + (k + 2) % 3]];
                if (a.side != VertexSide::Outside || a.across[0] != 0 || b.across[0] != 0) continue;
                const double height = glm::length(glm::cross(b.position - a.position, c.position - a.position)) /
                                      glm::distance(a.position, b.position);
                const double width = geometry.boxes[a.solid].diagonal() / 4.0;
                const double expected = std::clamp(128.0 * height / width, 1.0, 128.0);
                QVERIFY(std::abs(c.across[0] - expected) <= 1.0);
                fine += c.across[0] < 64 ? 1 : 0;
            }
        }
        QVERIFY(fine > 100);
    }
    void textureIsPartOfScenesColouredByMaterial() {
        Project project = starterProject();
        const AssetBakes bakes = allBakes(project);
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
        project.assets[0].texture = Texture{.name = "checker.png", .image = image, .materials = {0}};
        SceneBuilder builder;
        const RenderScene textured = builder.sceneOf(project, bakes, {});
        QVERIFY(textured.batches[0].texture == image);
        const auto countOf = [](const RenderScene& scene, VertexSide side) {
            return std::ranges::count(scene.batches[0].geometry->vertices, side, &SceneVertex::side);
        };
        QVERIFY(countOf(textured, VertexSide::Textured) > 0 && countOf(textured, VertexSide::Inside) > 0);
        QCOMPARE(countOf(textured, VertexSide::Outside), 0);
        const RenderScene byFragment = builder.sceneOf(project, bakes, {.colouring = SceneColouring::Fragment});
        QVERIFY(!byFragment.batches[0].texture && byFragment.batches[0].geometry == textured.batches[0].geometry);
        project.assets[0].texture.reset();
        const RenderScene plain = builder.sceneOf(project, bakes, {});
        QVERIFY(!plain.batches[0].texture);
        QCOMPARE(countOf(plain, VertexSide::Textured), 0);
    }
    void levelLimitsTheFragments() {
        Project project = starterProject();
        project.assets[0].levels = {
            {.pattern = {{{.id = project.nextId++, .parameters = UniformScatter{.count = 3}}}}}};
        const AssetBakes bakes = allBakes(project);
        QCOMPARE(sceneOf(project, bakes, {.level = 0}).poses.size(), std::size_t{20});
        std::size_t leaves = 0;
        for (std::uint32_t k = 0; k < bakes.begin()->second->fragmentCount(); ++k) {
            if (bakes.begin()->second->fragment(k).childCount == 0) ++leaves;
        }
        QVERIFY(leaves > 20);
        QCOMPARE(sceneOf(project, bakes).poses.size(), leaves);
    }
    void hullsHaveTheSameSolids() {
        const Project project = starterProject();
        const RenderScene scene = sceneOf(project, allBakes(project), {.hasHulls = true});
        QCOMPARE(scene.batches[0].hulls->solidCount(), scene.batches[0].geometry->solidCount());
        QVERIFY(!sceneOf(project, allBakes(project)).batches[0].hulls);
    }
    /// The geometry of 50,000 fragments is 100 MB, which took as long to move about while it grew as to compute.
    void geometryHasRoomForAllFragmentsAtOnce() {
        const Project project = wallOf(3000);
        const RenderScene scene = sceneOf(project, allBakes(project));
        const SceneGeometry& geometry = *scene.batches[0].geometry;
        const auto isTight = [](const auto& values) { return 10 * values.capacity() < 11 * values.size(); };
        QVERIFY(isTight(geometry.vertices));
        QVERIFY(isTight(geometry.indices));
        QVERIFY(isTight(geometry.boxes));
    }
    /// Linear: 4. Quadratic: 16.
    void explodingAndSelectingGrowWithTheFragments() {
        const double small = sceneTime(4000), large = sceneTime(16'000);
        QVERIFY2(large < 9.0 * small, qPrintable(QString("%1 ms, %2 ms").arg(small).arg(large)));
    }
};

RUBBLE_TEST_WITH(SceneBuilderTest, QCoreApplication)
#include "SceneBuilderTest.moc"
