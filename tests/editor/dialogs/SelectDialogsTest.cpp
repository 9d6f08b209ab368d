#include "editor/dialogs/SelectDialogs.h"

#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QApplication>
#include <QLabel>

using namespace rubble;

class SelectDialogsTest : public QObject {
    Q_OBJECT
private slots:
    void rangeBeginsWithAllFragmentsAndCountsThem() {
        const Result<Bake> bake = rubble::bake(boxAsset(2, 3, UniformScatter{.count = 8}));
        QVERIFY(bake);
        VolumeRangeDialog dialog(*bake, {}, nullptr);
        QVERIFY(dialog.min() <= dialog.max());
        QVERIFY2(countText(dialog).contains("8 of 8"), qPrintable(countText(dialog)));
        NumberField* most = dialog.findChildren<NumberField*>().last();
        most->setValue(0.5 * dialog.min());
        emit most->edited(most->value());
        QVERIFY2(countText(dialog).contains("0 of 8"), qPrintable(countText(dialog)));
    }
    void fractionAndSeedAreAsGiven() {
        const RandomFractionDialog dialog(35, 7, nullptr);
        QCOMPARE(dialog.percent(), 35);
        QCOMPARE(dialog.randomSeed(), quint64{7});
    }

private:
    static QString countText(const QDialog& dialog) {
        QStringList texts;
        for (const QLabel* label : dialog.findChildren<QLabel*>()) texts << label->text();
        return texts.join('\n');
    }
};

RUBBLE_TEST_WITH(SelectDialogsTest, QApplication)
#include "SelectDialogsTest.moc"
