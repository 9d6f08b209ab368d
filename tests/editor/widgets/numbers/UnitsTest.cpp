#include "editor/widgets/numbers/Units.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class UnitsTest : public QObject {
    Q_OBJECT
private slots:
    void areasAndVolumesFollowTheUnitOfLength() {
        const Units centimetres{LengthUnit::Centimetre};
        QCOMPARE(centimetres.lengths().unit, "cm");
        QCOMPARE(centimetres.areas().unit, "cm²");
        QCOMPARE(centimetres.volumes().unit, "cm³");
        QCOMPARE(centimetres.lengths().size(), 0.01);
        QCOMPARE(centimetres.volumes().size(), 1e-6);
        QCOMPARE(Units{LengthUnit::Foot}.lengths().size(), 0.3048);
    }
    void gridsAreRoundInFeetOrInMetres() {
        QCOMPARE(Units{LengthUnit::Foot}.roundLength(), 0.3048);
        for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre})
            QCOMPARE(Units{unit}.roundLength(), 1.0);
    }
    void millisecondsAreStoredAsSeconds() {
        QCOMPARE(Units::milliseconds().size(), 1e-3);
        QCOMPARE(Units::milliseconds().family, Units::seconds().family);
        QCOMPARE(Units::megapascals().size(), 1e6);
    }
};

RUBBLE_TEST(UnitsTest)
#include "UnitsTest.moc"
