// Tests viewport/scene/BondStrengths.cpp, and colours by it in viewport/scene/BodyColours.cpp.
#include "viewport/scene/BondStrengths.h"

#include "core/asset/bake/AssetBakes.h"
#include "core/asset/project/FragmentColours.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rubble;

namespace {

/// A bonded wall, its lower half twice as strong as its upper one.
Project gradedWall() {
    Project project = test::bondedWall(60, 100.0);
    project.assets[0].bonding.heightStrengths = {{1.49, 2.0}, {1.51, 1.0}};
    return project;
}

AssetModel modelOfWall(const Project& project) {
    const AssetBakes bakes = *bakesOf(project);
    return modelOf(project.assets[0], bakes.begin()->second, {.colouring = SceneColouring::BondStrength});
}

}  // namespace

class BondStrengthsTest : public QObject {
    Q_OBJECT
private slots:
    void meanOfTheBondsIsTheStrength() {
        const Project project = gradedWall();
        const AssetModel model = modelOfWall(project);
        const std::vector<double> strengths = bondStrengths(model, project);
        QCOMPARE(strengths.size(), model.solids.size());
        int low = 0, high = 0;
        for (std::size_t k = 0; k < strengths.size(); ++k) {
            const double y = model.solids[k].offset.y;
            if (y < -0.6) QVERIFY(qFuzzyCompare(strengths[k], 200.0) && ++low);
            if (y > 0.6) QVERIFY(qFuzzyCompare(strengths[k], 100.0) && ++high);
            QVERIFY(strengths[k] >= 100.0 - 1e-9 && strengths[k] <= 200.0 + 1e-9);
        }
        QVERIFY(low > 5 && high > 5);
    }
    void currentStateOfTheAssetCounts() {
        Project project = gradedWall();
        const AssetModel model = modelOfWall(project);
        project.assets[0].bonding.impulsePerArea = 50.0;
        QVERIFY(qFuzzyCompare(std::ranges::max(bondStrengths(model, project)), 100.0));
    }
    void wholeAssetsHaveNone() {
        Project project = gradedWall();
        project.assets[0].breakAs = BreakAs::Whole;
        const std::vector<double> strengths = bondStrengths(modelOfWall(project), project);
        QVERIFY(std::ranges::all_of(strengths, [](double strength) { return std::isnan(strength); }));
    }
    void whatNeverBreaksIsInfinite() {
        Project project = gradedWall();
        project.assets[0].bonding.strokes = {
            {.brush = BondBrush::NeverBreaks, .radius = 10.0, .points = {Vec2(0.0, 0.0)}}};
        const std::vector<double> strengths = bondStrengths(modelOfWall(project), project);
        QVERIFY(std::ranges::all_of(strengths, [](double strength) { return std::isinf(strength); }));
    }
    void coloursShowThem() {
        Project project = gradedWall();
        const AssetBakes bakes = *bakesOf(project);
        const SceneOptions options{.colouring = SceneColouring::BondStrength};
        const RenderScene scene = sceneOf(project, bakes, options);
        QCOMPARE(scene.colourRange->least, 100.0);
        QCOMPARE(scene.colourRange->most, 200.0);
        const auto hasColour = [](const RenderScene& shown, const Colour& colour) {
            return std::ranges::any_of(shown.appearances, [&](const BodyAppearance& appearance) {
                return appearance.outside == packed(colour);
            });
        };
        QVERIFY(hasColour(scene, rampColour(0.0)) && hasColour(scene, rampColour(1.0)));
        project.instances[0].bondStrength = 3.0;
        QCOMPARE(sceneOf(project, bakes, options).colourRange->most, 600.0);
        project.assets[0].breakAs = BreakAs::Whole;
        const RenderScene grey = sceneOf(project, bakes, options);
        QVERIFY(!grey.colourRange);
        QVERIFY(std::ranges::all_of(grey.appearances, [&](const BodyAppearance& appearance) {
            return appearance.outside == grey.appearances[0].outside;
        }));
    }
};

RUBBLE_TEST(BondStrengthsTest)
#include "BondStrengthsTest.moc"
