#include "editor/panels/models/MessagesModel.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QLocale>
#include <QTest>

using namespace rubble;

class MessagesModelTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void noDataIsThatOfNoRow() {  // for which an empty list asks when its current row is copied
        Messages messages;
        Document document{Project()};
        QVERIFY(!MessagesModel(messages, document).data(QModelIndex(), Qt::DisplayRole).isValid());
    }
    void timesAreInTheLocale_data() {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QString>("text");
        QTest::newRow("English") << "en_US"
                                 << "3:04:59 PM";
        QTest::newRow("German") << "de_DE"
                                << "15:04:59";
        QTest::newRow("Chinese") << "zh_CN"
                                 << "15:04:59";
        QTest::newRow("Korean") << "ko_KR" << QString::fromUtf8("오후 3시 4분 59초");
    }
    void timesAreInTheLocale() {
        QFETCH(const QString, locale);
        QLocale::setDefault(QLocale(locale));
        QTEST(timeShown().replace(QChar(0x202f), ' '), "text");
    }
    void noLocaleShowsATimeZone() {
        for (const QLocale& locale :
             QLocale::matchingLocales(QLocale::AnyLanguage, QLocale::AnyScript, QLocale::AnyTerritory)) {
            QLocale::setDefault(locale);
            const QString seconds = locale.toString(QTime(15, 4, 59), "ss"), shown = timeShown();
            QVERIFY2(shown.contains(seconds), qPrintable(locale.name() + ' ' + shown));
            QVERIFY2(!shown.contains("UTC"), qPrintable(locale.name() + ' ' + shown));
        }
    }

private:
    static QString timeShown() {
        Document document{Project()};
        Messages messages;
        messages.add({.text = "text", .time = QDateTime({2026, 1, 2}, {15, 4, 59}, Qt::UTC)});
        const MessagesModel model(messages, document);
        return model.data(model.index(0, MessagesModel::kTime), Qt::DisplayRole).toString();
    }
};

RUBBLE_TEST_WITH(MessagesModelTest, QApplication)
#include "MessagesModelTest.moc"
