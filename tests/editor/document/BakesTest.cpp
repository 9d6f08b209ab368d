#include "editor/document/Bakes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

std::shared_ptr<const BakedPattern> patternOf(const Asset& asset, const FragmentPath& parent = {}) {
    auto pattern = std::make_shared<BakedPattern>();
    pattern->asset = std::make_shared<const Asset>(asset);
    pattern->parent = parent;
    return pattern;
}

}  // namespace

class BakesTest : public QObject {
    Q_OBJECT
private slots:
    void keepsOnePatternOfAFragment() {
        const Asset asset = boxAsset(2, 3, UniformScatter{});
        Bakes bakes;
        QSignalSpy changes(&bakes, &Bakes::patternChanged);
        const auto whole = patternOf(asset), first = patternOf(asset, "3.0"), second = patternOf(asset, "3.1");
        for (const auto& pattern : {whole, first, second}) bakes.setPattern(2, pattern);
        QCOMPARE(changes.count(), 3);
        QCOMPARE(bakes.findPattern(2), whole);
        QCOMPARE(bakes.findPattern(2, "3.1"), second);
        QVERIFY(!bakes.findPattern(2, "3.0") && !bakes.findPattern(4, "3.1"));
        bakes.remove(2);
        QVERIFY(!bakes.findPattern(2) && !bakes.findPattern(2, "3.1"));
    }
    void areCurrentUntilTheAssetChanges() {
        Project project;
        project.materials = {{.id = 1, .name = "stone"}};
        project.assets = {boxAsset(2, 3, UniformScatter{})};
        project.instances = {{.id = 9, .name = "box", .asset = 2}};
        Bakes bakes;
        QVERIFY(!bakes.areCurrent(project));
        auto baked = std::make_shared<BakedAsset>();
        baked->asset = std::make_shared<const Asset>(project.assets[0]);
        bakes.set(2, baked);
        QVERIFY(bakes.areCurrent(project));
        project.assets[0].prism().depth *= 2.0;
        QVERIFY(!bakes.areCurrent(project));
    }
};

RUBBLE_TEST_WITH(BakesTest, QCoreApplication)
#include "BakesTest.moc"
