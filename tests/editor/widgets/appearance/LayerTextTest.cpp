#include "editor/widgets/appearance/LayerText.h"

#include "editor/widgets/Icon.h"
#include "tests/support/TestProgram.h"

#include <QGuiApplication>
#include <QTest>

using namespace rubble;

namespace {

QString textOfLayer(const LayerParameters& parameters, const Units& units = {}) {
    return layerText({.parameters = parameters}, units, QLocale::c()).replace(QChar(QChar::Nbsp), ' ');
}

}  // namespace

class LayerTextTest : public QObject {
    Q_OBJECT
private slots:
    void countsAreWrittenInAllThreeWays() {
        QCOMPARE(textOfLayer(UniformScatter{.count = 7}), "Uniform, 7 seeds");
        QCOMPARE(textOfLayer(UniformScatter{.count = 1}), "Uniform, 1 seed");
        QCOMPARE(textOfLayer(UniformScatter{.count = SeedCount(CountBy::Density, 12.5)}), "Uniform, 12.5 per m²");
        QCOMPARE(textOfLayer(UniformScatter{.count = SeedCount(CountBy::FragmentSize, 0.25)}),
                 "Uniform, fragments of 0.25 m");
    }
    void lengthsAreInThePreferredUnit() {
        QCOMPARE(textOfLayer(BlueNoise{.minimumDistance = 0.2}), "Blue noise, 0.2 m apart");
        QCOMPARE(numberedLayerText({.id = 3, .parameters = UniformScatter{.count = 7}}), "3 · Uniform, 7 seeds");
        QCOMPARE(textOfLayer(BlueNoise{.minimumDistance = 0.2}, {LengthUnit::Centimetre}), "Blue noise, 20 cm apart");
    }
    void summaryDependsOnOptions() {
        JitteredGrid grid{.columns = 4, .rows = 3, .cellWidth = 0.5, .cellHeight = 0.25};
        QCOMPARE(textOfLayer(grid), "Jittered grid, 4 × 3");
        grid.cells = GridCells::Size;
        QCOMPARE(textOfLayer(grid), "Jittered grid, 0.5 m × 0.25 m");
        QCOMPARE(textOfLayer(DensityImage{}), "Density image, no picture");
    }
    void elementsAreCounted() {
        QCOMPARE(textOfLayer(PlacedSeeds{{{0, {0.1, 0.2}}, {1, {0.3, 0.4}}}}), "Placed seeds, 2");
        QCOMPARE(textOfLayer(CrackLines{}), "Crack lines, 0 lines");
    }
    void everyKindHasAnIconAndACompleteSummary() {
        for (const PatternKind* kind : patternKinds()) {
            QVERIFY2(!iconNamed(kind->icon).isNull(), kind->icon);
            const QString summary = textOfLayer(kind->defaultsFor({{0.0, 0.0}, {2.0, 1.0}}));
            QVERIFY2(!summary.contains('{') && !summary.contains('%'), qPrintable(summary));
        }
    }
};

RUBBLE_TEST_WITH(LayerTextTest, QGuiApplication)
#include "LayerTextTest.moc"
