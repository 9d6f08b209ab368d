#include "core/asset/project/Project.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

Project twoAssets() {
    Project project;
    project.nextId = 10;
    project.materials = {{.id = 1, .name = "brick"}, {.id = 4, .name = "tile"}};
    project.assets = {{.id = 2, .name = "wall", .material = 1}, {.id = 7, .name = "roof", .material = 4}};
    return project;
}

}  // namespace

class ProjectTest : public QObject {
    Q_OBJECT
private slots:
    void elementsAreFoundById() {
        const Project project = twoAssets();
        QCOMPARE(findMaterial(project, 4), &project.materials[1]);
        QCOMPARE(findAsset(project, 2), &project.assets[0]);
        QCOMPARE(findAsset(project, 7), &project.assets[1]);
    }
    void assetsAreFoundByName() {
        const Project project = twoAssets();
        QCOMPARE(findAsset(project, "roof"), &project.assets[1]);
        QVERIFY(findAsset(project, "Roof") == nullptr);
    }
    void missingElementsGiveNull() {
        const Project project = twoAssets();
        QVERIFY(findMaterial(project, 2) == nullptr);
        QVERIFY(findAsset(project, 8) == nullptr);
        QVERIFY(findAsset(Project{}, 1) == nullptr);
    }
    void surfacesAreComparedByValue() {
        Asset first;
        first.surface = std::make_shared<Surface>(Surface{.materials = {"plaster"}});
        Asset second = first;
        second.surface = std::make_shared<Surface>(Surface{.materials = {"plaster"}});
        QVERIFY(first == second);
        second.surface = std::make_shared<Surface>(Surface{.materials = {"brick"}});
        QVERIFY(!(first == second));
        second.surface = nullptr;
        QVERIFY(!(first == second));
    }
    void equalityComparesEveryMemberOfAnAsset() {
        const Asset asset;
        const auto differs = [&](auto&& change) {
            Asset changed = asset;
            change(changed);
            return !(changed == asset);
        };
        QVERIFY(differs([](Asset& changed) { changed.id = 1; }));
        QVERIFY(differs([](Asset& changed) { changed.name = "a"; }));
        QVERIFY(differs([](Asset& changed) { changed.material = 1; }));
        QVERIFY(differs([](Asset& changed) { changed.prism().depth = 2.0; }));
        QVERIFY(differs([](Asset& changed) { changed.pattern.layers.resize(1); }));
        QVERIFY(differs([](Asset& changed) { changed.levels.resize(1); }));
        QVERIFY(differs([](Asset& changed) { changed.threshold = 1.0; }));
        QVERIFY(differs([](Asset& changed) { changed.insideUvScale = 2.0; }));
        QVERIFY(differs([](Asset& changed) { changed.cutAtImpact.emplace(); }));
        QVERIFY(differs([](Asset& changed) { changed.requirements.resize(1); }));
    }
};

RUBBLE_TEST(ProjectTest)
#include "ProjectTest.moc"
