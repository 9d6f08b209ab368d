#include "editor/dialogs/sheet/ContactSheetText.h"

#include "editor/document/Translations.h"
#include "tests/support/TestProgram.h"

#include <QApplication>

using namespace rubble;

class ContactSheetTextTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { installTranslations(); }
    void everyMeasureHasAName() {
        QStringList names;
        for (int k = 0; k < kSheetMeasures; ++k) names << measureName(static_cast<SheetMeasure>(k));
        QVERIFY(!names.contains(QString()));
        QCOMPARE(names.removeDuplicates(), 0);
    }
    void captionHasTheFigures() {
        SheetEntry entry{.figures = {.fragments = 1, .smallestFragment = 0.0005, .aspect = 3.2}};
        QCOMPARE(plain(captionOf(entry, {})), "Current · 1 fragment\nsmallest 500 cm³, longest 3.2 : 1");
        entry.number = 3;
        entry.figures.isPlayed = true;
        QVERIFY(captionOf(entry, {}).startsWith("No. 3 · "));
        QVERIFY(captionOf(entry, {}).endsWith("\ndid not break"));
        entry.figures.breakImpact = 120.0;
        entry.figures.debrisHeight = 0.5;
        QVERIFY2(
            plain(captionOf(entry, {LengthUnit::Centimetre})).endsWith("\nbroke at 120 N·s, debris up to 50 cm high"),
            qPrintable(captionOf(entry, {LengthUnit::Centimetre})));
        entry.fault = "It has no area.";
        QCOMPARE(captionOf(entry, {}), "No. 3\nIt has no area.");
    }
    void changesOfFragmentsAreCounted() {
        Asset asset;
        asset.edits.resize(2);
        asset.fragmentLevels.resize(1);
        const QStringList lines = fragmentChanges(asset).split('\n');
        QCOMPARE(lines[0], "2 merges or splits");
        QCOMPARE(lines[1], "1 pattern of single fragments");
        QCOMPARE(lines[2], "");
    }

private:
    static QString plain(QString text) { return text.replace(QChar(QChar::Nbsp), ' '); }
};

RUBBLE_TEST_WITH(ContactSheetTextTest, QApplication)
#include "ContactSheetTextTest.moc"
