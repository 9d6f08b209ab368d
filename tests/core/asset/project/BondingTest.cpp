#include "core/asset/project/Bonding.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class BondingTest : public QObject {
    Q_OBJECT
private slots:
    void strengthImagesAreComparedByTheirPixels() {
        const GreyImage image{.width = 1, .height = 1, .grey = {100}};
        const StrengthImage one{.image = std::make_shared<const GreyImage>(image)};
        StrengthImage other{.image = std::make_shared<const GreyImage>(image)};
        QVERIFY(one == other);
        other.brightest = 2.0;
        QVERIFY(!(one == other));
        GreyImage darker = image;
        darker.grey[0] = 99;
        other = {.image = std::make_shared<const GreyImage>(darker)};
        QVERIFY(!(one == other));
        QVERIFY(!(one == StrengthImage{}));
        QVERIFY(StrengthImage{} == StrengthImage{});
    }
};

RUBBLE_TEST(BondingTest)
#include "BondingTest.moc"
