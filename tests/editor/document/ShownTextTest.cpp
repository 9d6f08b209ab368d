#include "editor/document/ShownText.h"

#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"

#include <QTextDocument>

using namespace rubble;

class ShownTextTest : public QObject {
    Q_OBJECT
private slots:
    void namesArePrintableAndShort() {
        QCOMPARE(nameText("W\u00e4nd"), QString("W\u00e4nd"));
        QCOMPARE(nameText("a\nb\x1b"), QString("a\\u000ab\\u001b"));
        QCOMPARE(nameText(std::string(10000, 'x')).size(), 60);
    }
    void fileNamesArePrintable() {
        QCOMPARE(fileNameText("/home/wall.rubble"), QString("wall.rubble"));
        QCOMPARE(fileNameText(fromPath("/home/h\xff.rubble")), QString("h\\xff.rubble"));
    }
    void pathsArePrintableAndWhole() {
        const std::string path = "/" + std::string(200, 'x') + "/h\xff";
        QCOMPARE(pathText(fromPath(path)), QString::fromStdString("/" + std::string(200, 'x') + "/h\\xff"));
    }
    void menusShowAmpersands() { QCOMPARE(menuText("Romeo & Juliet"), QString("Romeo && Juliet")); }
    void toolTipsShowMarkup() {
        QCOMPARE(toolTipText("Baking wall"), QString("Baking wall"));
        const QString html = toolTipText("Baking <img src=\"/etc/passwd\">");
        QTextDocument shown;
        shown.setHtml(html);
        QVERIFY(Qt::mightBeRichText(html) && !html.contains("<img"));
        QCOMPARE(shown.toPlainText(), QString("Baking <img src=\"/etc/passwd\">"));
    }
};

RUBBLE_TEST(ShownTextTest)
#include "ShownTextTest.moc"
