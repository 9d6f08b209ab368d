#include "core/asset/PieceColours.h"
#include "core/asset/StarterProject.h"
#include "viewport/scene/SceneBuilder.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

AssetBakes allBakes(const Project& project) { return bakesOf(project).value(); }

/// The starter's wall twice: as it stands, and two metres to the right, turned about y by a quarter.
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

bool isNear(Vec3 a, Vec3 b) { return glm::length(a - b) < 1e-6; }

}  // namespace

class SceneBuilderTest : public QObject {
    Q_OBJECT
private slots:
    void everyInstanceSharesOneGeometry() {
        const Project project = twoWalls();
        const RenderScene scene = sceneOf(project, allBakes(project));
        QCOMPARE(scene.batches.size(), std::size_t{1});
        QCOMPARE(scene.batches[0].firstBodies, (std::vector<std::uint32_t>{0, 20}));
        QCOMPARE(scene.batches[0].geometry->pieceCount(), 20u);
        QCOMPARE(scene.motions.size(), std::size_t{40});
        QVERIFY((scene.picks[25] == PickId{project.assets[0].id, project.instances[1].id, 5}));
    }
    void instancesStandByTheirPoses() {
        const Project project = twoWalls();
        const Box3 bounds = boundsOf(sceneOf(project, allBakes(project)));
        const Vec3 first = project.instances[0].pose.position;
        QVERIFY(isNear(bounds.min, first - Vec3(0.5, 0.5, 0.5)));
        QVERIFY(isNear(bounds.max, first + Vec3(2.25, 0.5, 0.5)));
    }
    void farFromZeroNothingIsRounded() {
        Project project = starterProject();
        project.instances[0].pose.position = {1e7, 2e7, -1e7};
        const RenderScene scene = sceneOf(project, allBakes(project));
        QVERIFY(isNear(boundsOf(scene).max - boundsOf(scene).min, {1.0, 1.0, 0.5}));
    }
    void withoutABakeAnAssetIsWhole() {
        const Project project = starterProject();
        const RenderScene scene = sceneOf(project, {});
        QCOMPARE(scene.motions.size(), std::size_t{1});
        QCOMPARE(scene.picks[0].fragment, kNone);
        QVERIFY(isNear(boundsOf(scene).max - boundsOf(scene).min, {1.0, 1.0, 0.5}));
    }
    void aPrismThatCannotBeFracturedIsLeftOut() {
        Project project = starterProject();
        std::swap(project.assets[0].prism.outline.outer[0], project.assets[0].prism.outline.outer[1]);
        QVERIFY(sceneOf(project, {}).batches.empty());
        QVERIFY(boundsOf(sceneOf(project, {})).isEmpty());
    }
    void explodedTwicePiecesStandTwiceAsFarFromTheMiddle() {
        const Project project = starterProject();
        const RenderScene together = sceneOf(project, allBakes(project));
        const RenderScene apart = sceneOf(project, allBakes(project), {.exploded = 1.0});
        QVERIFY(together.batches[0].firstBodies == apart.batches[0].firstBodies);
        const Vec3 foot = boundsOf(together).centre() - Vec3(0.0, 0.5, 0.0);
        for (std::size_t k = 0; k < apart.motions.size(); ++k) {
            const Vec3 arm = together.origin + Vec3(together.motions[k].position) - foot;
            QVERIFY(isNear(Vec3(apart.apart[k]), arm));
        }
        QVERIFY(boundsOf(apart).min.y > boundsOf(together).min.y - 1e-6);  // nothing goes below the ground
    }
    void colouringByVolumeRunsFromTheSmallestToTheLargest() {
        const Project project = starterProject();
        const AssetBakes bakes = allBakes(project);
        std::vector<double> volumes;
        for (std::uint32_t k = 0; k < 20; ++k) volumes.push_back(bakes.begin()->second->fragment(k).solid.volume());
        const auto [least, most] = std::ranges::minmax_element(volumes);
        const RenderScene scene = sceneOf(project, bakes, {.colouring = SceneColouring::Volume});
        QCOMPARE(scene.looks[static_cast<std::size_t>(least - volumes.begin())].outside, packed(rampColour(0.0)));
        QCOMPARE(scene.looks[static_cast<std::size_t>(most - volumes.begin())].outside, packed(rampColour(1.0)));
    }
    void aColourOfAPieceStaysWhenOthersCome() {
        Project project = starterProject();
        const RenderScene few = sceneOf(project, allBakes(project), {.colouring = SceneColouring::Piece});
        std::get<UniformScatter>(project.assets[0].pattern.layers[0].parameters).count = 30;
        const RenderScene more = sceneOf(project, allBakes(project), {.colouring = SceneColouring::Piece});
        QCOMPARE(few.looks[7].outside, more.looks[7].outside);
        QVERIFY(few.looks[7].outside != few.looks[8].outside);
        QVERIFY(few.looks[7].outside != few.looks[7].inside);
    }
    void marksStandForOneOrForMany() {
        const Project project = twoWalls();
        RenderScene scene = sceneOf(project, allBakes(project));
        const Id asset = project.assets[0].id, second = project.instances[1].id;
        setMarks(scene,
                 {.hidden = {{asset, 0, 3}}, .selected = {{asset, second, kNone}}, .hovered = {{asset, second, 4}}});
        QCOMPARE(scene.looks[3].marks, kHidden);
        QCOMPARE(scene.looks[23].marks, kHidden | kSelected);
        QCOMPARE(scene.looks[24].marks, kSelected | kHovered);
        QCOMPARE(scene.looks[4].marks, 0u);
        QVERIFY(isNear(boundsOf(scene, kSelected).min, project.instances[1].pose.position - Vec3(0.25, 0.5, 0.5)));
        setMarks(scene, {});
        QCOMPARE(scene.looks[23].marks, 0u);
    }
    void whatDidNotChangeIsShared() {
        const Project project = starterProject();
        AssetBakes bakes = allBakes(project);
        SceneBuilder builder;
        const RenderScene first = builder.sceneOf(project, bakes, {});
        const RenderScene apart = builder.sceneOf(project, bakes, {.exploded = 1.0});
        QVERIFY(first.batches[0].geometry == apart.batches[0].geometry);
        Project other = project;
        other.assets[0].pattern.layers[0].randomSeed += 1;
        const RenderScene changed = builder.sceneOf(other, allBakes(other), {});
        QVERIFY(changed.batches[0].geometry != first.batches[0].geometry);
    }
    void levelsAreShownDownToTheOneAskedFor() {
        Project project = starterProject();
        project.assets[0].levels = {
            {.pattern = {{{.id = project.nextId++, .parameters = UniformScatter{.count = 3}}}}}};
        const AssetBakes bakes = allBakes(project);
        QCOMPARE(sceneOf(project, bakes, {.level = 0}).motions.size(), std::size_t{20});
        std::size_t leaves = 0;
        for (std::uint32_t k = 0; k < bakes.begin()->second->fragmentCount(); ++k) {
            if (bakes.begin()->second->fragment(k).childCount == 0) ++leaves;
        }
        QVERIFY(leaves > 20);
        QCOMPARE(sceneOf(project, bakes).motions.size(), leaves);
    }
    void hullsComeWithTheSamePieces() {
        const Project project = starterProject();
        const RenderScene scene = sceneOf(project, allBakes(project), {.hasHulls = true});
        QCOMPARE(scene.batches[0].hulls->pieceCount(), scene.batches[0].geometry->pieceCount());
        QVERIFY(!sceneOf(project, allBakes(project)).batches[0].hulls);
    }
};

QTEST_GUILESS_MAIN(SceneBuilderTest)
#include "SceneBuilderTest.moc"
