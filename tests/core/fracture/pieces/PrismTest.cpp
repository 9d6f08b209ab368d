#include "core/fracture/pieces/Prism.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <limits>

using namespace rubble;

class PrismTest : public QObject {
    Q_OBJECT
private slots:
    void windingIsMadeCanonical() {
        const Result<Prism> prism = validated(Prism{{reversed(unitSquare().outer), {}}, 0.5});
        QVERIFY(prism.hasValue());
        QCOMPARE(signedArea(prism->outline.outer), 1.0);
        QCOMPARE(prism->depth, 0.5);
    }
    void invalidDepthsAreRejected() {
        const auto error = [](double depth) { return validated(Prism{unitSquare(), depth}).error(); };
        QCOMPARE(error(0.0).message, std::string("The depth is 0; it must be finite and greater than zero."));
        QCOMPARE(error(-0.5).message, std::string("The depth is -0.5; it must be finite and greater than zero."));
        QVERIFY(error(std::numeric_limits<double>::infinity()).code == ErrorCode::BadInput);
        QVERIFY(error(std::numeric_limits<double>::quiet_NaN()).code == ErrorCode::BadInput);
        QCOMPARE(error(1e-300).message, std::string("The depth is 1e-300; it must be between 1e-60 and 1e+60."));
    }
    void invalidOutlinesAreRejected() {
        const Result<Prism> prism = validated(Prism{{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}, 1.0});
        QVERIFY(prism.error().code == ErrorCode::Crossing);
        QCOMPARE(prism.error().message,
                 std::string("The outline crosses itself between points 0 and 2, at (0.5, 0.5)."));
    }
};

RUBBLE_TEST(PrismTest)
#include "PrismTest.moc"
