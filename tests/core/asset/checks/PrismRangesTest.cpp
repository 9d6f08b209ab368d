// Tests core/asset/project/Ranges.cpp: assets with numbers at the ends of their ranges are fractured without a fault.
#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/project/Ranges.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

class PrismRangesTest : public QObject {
    Q_OBJECT
private slots:
    void prismsAtTheEndsAreSound_data() {
        QTest::addColumn<double>("coordinate");
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("depth");
        QTest::addColumn<double>("gap");
        QTest::addColumn<double>("roughness");
        const auto ends = [](ProjectNumber number) { return std::array{rangeOf(number).min, rangeOf(number).max}; };
        for (const double size : ends(ProjectNumber::OutlineSize)) {
            for (const double depth : ends(ProjectNumber::PrismDepth)) {
                QTest::addRow("size %g, depth %g", size, depth) << 0.0 << size << depth << 0.0 << 0.0;
            }
        }
        for (const double far : ends(ProjectNumber::OutlineCoordinate)) {
            QTest::addRow("at %g", far) << (far > 0.0 ? far - 1.0 : far) << 1.0 << 0.5 << 0.0 << 0.0;
        }
        const NumberRange &gap = rangeOf(ProjectNumber::Gap), &rough = rangeOf(ProjectNumber::RoughnessAmplitude);
        QTest::addRow("gap %g", gap.leastAboveZero) << 0.0 << 1.0 << 0.5 << gap.leastAboveZero << 0.0;
        QTest::addRow("rough %g", rough.leastAboveZero) << 0.0 << 1.0 << 0.5 << 0.0 << rough.leastAboveZero;
        QTest::addRow("rough %g", rough.max) << 0.0 << 1.0 << 0.5 << 0.0 << rough.max;
    }
    void prismsAtTheEndsAreSound() {
        QFETCH(double, coordinate);
        QFETCH(double, size);
        QFETCH(double, depth);
        QFETCH(double, gap);
        QFETCH(double, roughness);
        Asset asset = boxAsset(2, 3, UniformScatter{.count = 20});
        for (Vec2& corner : asset.prism().outline.outer) {
            corner = {coordinate + (corner.x > 0.0 ? size : 0.0), coordinate + (corner.y > 0.0 ? size : 0.0)};
        }
        asset.prism().depth = depth;
        asset.shaping.gap = gap;
        asset.shaping.roughness.amplitude = roughness;
        const Result<Bake> made = bake(asset);
        QVERIFY2(made, made ? "" : made.error().message.c_str());
        QCOMPARE(made->fragmentCount(), 20u);
        for (const auto verify : {verifyBake, verifyMeshes}) {
            const std::optional<std::string> fault = verify(*made, asset);
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
};

RUBBLE_TEST(PrismRangesTest)
#include "PrismRangesTest.moc"
