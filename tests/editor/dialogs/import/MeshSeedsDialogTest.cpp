#include "editor/dialogs/import/MeshSeedsDialog.h"

#include "editor/document/Translations.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace rubble;

namespace {

SourceScene meshOf(std::vector<Vec3> points) { return {.objects = {{.name = "mesh", .points = std::move(points)}}}; }

}  // namespace

class MeshSeedsDialogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { installTranslations(); }

    void optionsUpdateTheSeeds() {
        MeshSeedsDialog dialog("cracks.obj", meshOf({{25.0, 50.0, 0.0}, {75.0, 50.0, 0.0}, {0.5, 0.5, 0.0}}),
                               unitSquare(), nullptr);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, kPatience));
        QCOMPARE(dialog.seeds().seeds.size(), std::size_t{1});
        QVERIFY(shows(dialog, "1 seed. 2 points of the mesh outside the outline were left out."));
        auto* unit = dialog.findChildren<QComboBox*>().front();
        unit->setFocus();
        QTest::keyClick(unit, Qt::Key_C);  // centimetres
        QVERIFY(shows(dialog, "3 seeds."));
        QTest::keyClick(dialog.findChild<QCheckBox*>(), Qt::Key_Space);
        QVERIFY(!unit->isEnabled());
        QCOMPARE(dialog.seeds().seeds.size(), std::size_t{3});
        QTest::keyClick(&dialog, Qt::Key_Return);
        QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    }
    void meshOutsideTheOutlineCannotBeAdded() {
        MeshSeedsDialog dialog("far.obj", meshOf({{25.0, 50.0, 0.0}}), unitSquare(), nullptr);
        QVERIFY(shows(dialog, "No point of the mesh lies in the outline."));
        QVERIFY(!addButton(dialog)->isEnabled());
    }

private:
    static bool shows(const QDialog& dialog, const QString& sentence) {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().trimmed() == sentence; });
    }
    static QPushButton* addButton(const QDialog& dialog) {
        for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
            if (button->text() == "Add Layer") return button;
        }
        return nullptr;
    }
};

RUBBLE_TEST_WITH(MeshSeedsDialogTest, QApplication)
#include "MeshSeedsDialogTest.moc"
