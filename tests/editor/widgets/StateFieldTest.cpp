#include "editor/widgets/StateField.h"

#include "editor/document/DocumentFile.h"
#include "tests/support/TestProgram.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace rubble;

namespace {

QStringList textsOf(const StateField& field) {
    QStringList texts;
    for (int k = 0; k < field.count(); ++k) texts << field.itemText(k);
    return texts;
}

void touch(const QString& path) { QVERIFY(QFile(path).open(QIODevice::WriteOnly)); }

}  // namespace

class StateFieldTest : public QObject {
    Q_OBJECT
private slots:
    void listsStatesBesideTheProject() {
        Document document{Project()};
        DocumentFile file(document);
        StateField field(file);
        field.showPopup();
        QCOMPARE(textsOf(field), QStringList{"Scene"});  // the project has no file
        const QTemporaryDir folder;
        QVERIFY(file.saveAs(folder.filePath("house.rubble")));
        for (const char* name : {"b.rubblestate", "a.rubblestate", "c.txt"}) touch(folder.filePath(name));
        field.setState("b.rubblestate");
        field.showPopup();
        QCOMPARE(textsOf(field), (QStringList{"Scene", "a.rubblestate", "b.rubblestate"}));
        QCOMPARE(field.state(), "b.rubblestate");
        field.setState({});
        QCOMPARE(field.currentText(), "Scene");
    }
    void missingStateStaysSelected() {
        Document document{Project()};
        const DocumentFile file(document);
        StateField field(file);
        const QSignalSpy edited(&field, &StateField::edited);
        field.setState("gone.rubblestate");
        QCOMPARE(field.currentText(), "gone.rubblestate (missing)");
        QCOMPARE(field.state(), "gone.rubblestate");
        QVERIFY(edited.isEmpty());
        emit field.activated(0);
        QCOMPARE(edited.size(), 1);
    }
};

RUBBLE_TEST_WITH(StateFieldTest, QApplication)
#include "StateFieldTest.moc"
