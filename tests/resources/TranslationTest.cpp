// Tests resources/translations/rubble_en.ts
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

using rubble::bytesOfFile;

namespace {

/// The texts with a count in the sources of the editor.
QSet<QString> textsInSources() {
    const QRegularExpression text("\"([^\"\\n]*%L?n[^\"\\n]*)\"");
    QSet<QString> texts;
    QDirIterator file(RUBBLE_SOURCE_DIR "/editor", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (file.hasNext()) {
        const QString source = QString::fromUtf8(bytesOfFile(file.next()));
        for (auto match = text.globalMatch(source); match.hasNext();) texts.insert(match.next().captured(1));
    }
    return texts;
}

}  // namespace

/// tools/translations mends what fails here.
class TranslationTest : public QObject {
    Q_OBJECT
private slots:
    void everyTextWithACountHasSingularAndPlural() {
        const QRegularExpression wrongPlural("([^aeiou]y|x|ch|sh|ss)s\\b");  // bodys, boxs, branchs
        QSet<QString> translated;
        QString source;
        QXmlStreamReader xml(bytesOfFile(RUBBLE_SOURCE_DIR "/resources/translations/rubble_en.ts"));
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) continue;
            if (xml.name() == QStringLiteral("source")) {
                source = xml.readElementText();
            } else if (xml.name() == QStringLiteral("translation")) {
                QVERIFY2(!xml.attributes().hasAttribute("type"), qPrintable(source));
            } else if (xml.name() == QStringLiteral("numerusform")) {
                const QString form = xml.readElementText();
                QVERIFY2(!form.isEmpty() && !form.contains("(s)"), qPrintable(source));
                QVERIFY2(!form.contains(wrongPlural), qPrintable(form));
                translated.insert(source);
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        for (const QString& text : textsInSources()) QVERIFY2(translated.contains(text), qPrintable(text));
    }
};

RUBBLE_TEST_WITH(TranslationTest, QCoreApplication)
#include "TranslationTest.moc"
