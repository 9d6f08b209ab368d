#include "editor/document/Translations.h"

#include "tests/support/TestProgram.h"

#include <QCoreApplication>
#include <QTranslator>

using namespace rubble;

class TranslationsTest : public QObject {
    Q_OBJECT
private slots:
    void countsHaveTheirPluralForm() {
        const auto text = [](int count) {
            return QCoreApplication::translate("rubble::ProblemPanel", "%Ln problem(s)", nullptr, count);
        };
        installTranslations();
        QCOMPARE(text(1), "1 problem");
        QCOMPARE(text(2), "2 problems");
    }
    void secondCallInstallsNothing() {
        installTranslations();
        installTranslations();
        QCOMPARE(QCoreApplication::instance()->findChildren<QTranslator*>().size(), 1);
    }
};

RUBBLE_TEST_WITH(TranslationsTest, QCoreApplication)
#include "TranslationsTest.moc"
