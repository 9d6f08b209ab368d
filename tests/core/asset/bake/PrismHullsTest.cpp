#include "core/asset/bake/PrismHulls.h"

#include "core/geometry/hull/MassProperties.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class PrismHullsTest : public QObject {
    Q_OBJECT
private slots:
    void hullsFillThePrism() {
        const Result<std::vector<Polytope>> hulls = prismHulls({lShape(), 0.5});
        QVERIFY(hulls && hulls->size() == 2);
        double volume = 0.0;
        for (const Polytope& hull : *hulls) {
            QCOMPARE(verifyPolytope(hull).value_or(""), "");
            volume += massOf(hull).volume;
        }
        QCOMPARE(volume, 1.5);
    }
    void originIsMovedToZero() {
        const Polytope box = prismHulls({unitSquare(), 1.0}, {0.5, 1.0})->front();
        Vec3 low = box.vertices[0];
        for (const Vec3 vertex : box.vertices) low = glm::min(low, vertex);
        QCOMPARE(low, Vec3(-0.5, -1.0, -0.5));
    }
    void assetsThatCannotBeFracturedAreLeftOut() {
        Project project;
        project.assets.resize(2);
        project.assets[0] = {.id = 3, .name = "box", .shape = Prism{unitSquare(), 1.0}};
        project.assets[1] = {.id = 4, .name = "line", .shape = Prism{{{{0, 0}, {1, 0}}, {}}, 1.0}};
        const AssetHulls all = assetHulls(project);
        QCOMPARE(all.size(), std::size_t{1});
        QCOMPARE(all.at(3).size(), std::size_t{1});
    }
};

RUBBLE_TEST(PrismHullsTest)
#include "PrismHullsTest.moc"
