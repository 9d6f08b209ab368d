// Tests editor/actions/AssetActions.cpp, editor/actions/MaterialActions.cpp and
// editor/dialogs/sheet/ContactSheetWindow.cpp.
#include "core/asset/library/StarterProject.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/MaterialDialog.h"
#include "editor/dialogs/SelectDialogs.h"
#include "editor/dialogs/sheet/ContactSheetWindow.h"
#include "editor/panels/inspector/ShapingSection.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/Windows.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

using namespace rubble;

/// The workflow of an artist with one wall, by mouse and keys: apply concrete, add a bullet hole, paint density, merge
/// small fragments, fracture large ones again, isolate some, and compare variants.
class ArtistStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        open(starterProject());
        selection().setAsset(wall().id);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        window().views().frameAsset();
        m_before = text();
    }
    void cleanupTestCase() { close(); }

    void libraryAppliesConcrete() {
        test::onNextDialog<MaterialDialog>([](MaterialDialog& dialog) {
            auto& list = *dialog.findChild<QListWidget*>();
            QListWidgetItem* concrete = list.findItems("concrete", Qt::MatchExactly).value(0);
            QVERIFY(concrete);
            list.scrollToItem(concrete);
            QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(concrete).center());
            for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
                if (button->text().remove('&').startsWith("Apply to")) QTest::mouseClick(button, Qt::LeftButton);
            }
        });
        act("material library");
        QTRY_COMPARE_WITH_TIMEOUT(findMaterial(project(), wall().material)->name, std::string("concrete"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
    }
    void radialLayerIsAddedAndDragged() {
        const std::size_t layers = wall().pattern.layers.size();
        act("add radial");
        QTRY_COMPARE_WITH_TIMEOUT(wall().pattern.layers.size(), layers + 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        const Vec2 from = hole().centre;
        drag(canvas(), pixels(from), pixels(from + Vec2(0.2, 0.15)));
        QVERIFY(glm::distance(hole().centre, from + Vec2(0.2, 0.15)) < 0.02);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
    }
    void brushAddsDensityLayer() {
        const std::size_t layers = wall().pattern.layers.size();
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_B, Qt::AltModifier);
        drag(canvas(), pixels({-0.4, -0.3}), pixels({-0.1, -0.3}));
        QCOMPARE(wall().pattern.layers.size(), layers + 1);
        QVERIFY(std::get<DensityImage>(wall().pattern.layers.back().parameters).image);
        Asset crushed = wall();
        std::get<DensityImage>(crushed.pattern.layers.back().parameters).count = 200;
        window().workspace().document().push(modify("Set Count", std::move(crushed)));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        m_fragments = bake().fragmentCount();
        QVERIFY(m_fragments > 100);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
    }
    void smallFragmentsAreMerged() {
        auto* rule = window().findChild<ShapingSection*>()->findChild<QComboBox*>();
        QVERIFY(rule);
        rule->setFocus();
        QTest::keyClick(rule, Qt::Key_Down);
        QCOMPARE(wall().shaping.smallPieces.rule, SmallPieceRule::Merge);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked() && bake().fragmentCount() < m_fragments, kPatience);
        double total = 0.0, smallest = 1.0;
        for (std::uint32_t k = 0; k < bake().fragmentCount(); ++k) {
            total += bake().fragment(k).solid.volume();
            smallest = std::min(smallest, bake().fragment(k).solid.volume());
        }
        QVERIFY(std::abs(total - bake().whole.volume) < 1e-9 * total);
        QVERIFY(smallest >= wall().shaping.smallPieces.limit * total / bake().fragmentCount() * (1.0 - 1e-9));
        m_fragments = bake().fragmentCount();
    }
    void largeFragmentsAreFracturedAgain() {
        test::onNextDialog<VolumeRangeDialog>([](VolumeRangeDialog& dialog) {
            auto& min = *dialog.findChildren<NumberField*>().front();
            min.setFocus();
            min.selectAll();
            QTest::keyClicks(&min, QString::number(0.6 * dialog.max(), 'g', 6));
            QTest::keyClick(&min, Qt::Key_Return);
            for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
                if (button->text().remove('&') == "Select") QTest::mouseClick(button, Qt::LeftButton);
            }
        });
        act("by volume");
        QTRY_VERIFY_WITH_TIMEOUT(!selection().seeds().empty(), kPatience);
        QVERIFY(selection().seeds().size() < m_fragments / 2);
        QTest::keyClick(&window(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!wall().fragmentLevels.empty(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked() && bake().fractures.size() > 1, kPatience);
        QCOMPARE(bake().fractures.back().level, 1u);
    }
    void selectionIsIsolatedAndAllShownAgain() {
        QApplication::setActiveWindow(&window());
        canvas().setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(canvas().hasFocus() && !selection().seeds().empty(), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Slash);
        QVERIFY(!selection().hidden().isEmpty());
        QTest::keyClick(&canvas(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
    }
    void contactSheetAppliesAVariant() {
        act("contact sheet");
        ContactSheetWindow* sheet = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((sheet = test::visibleWindow<ContactSheetWindow>()), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!sheet->generator().isBusy() && sheet->list().count() == 12, kPatience);
        const Pattern before = wall().pattern;
        QListWidget& list = sheet->list();
        QListWidgetItem* last = list.item(list.count() - 1);
        list.scrollToItem(last);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(last).center());
        test::onNextDialog<QMessageBox>([](QMessageBox& box) {
            for (QAbstractButton* button : box.buttons()) {
                if (button->text().remove('&') == "Keep") button->click();
            }
        });
        QTest::keyClick(&list, Qt::Key_Return);
        QVERIFY(wall().pattern != before);
        QVERIFY(!wall().fragmentLevels.empty());
        if (test::visibleWindow<ContactSheetWindow>()) QTest::keyClick(sheet, Qt::Key_Escape);
    }
    void everythingIsUndone() {
        window().activateWindow();
        QApplication::setActiveWindow(&window());
        while (stack().canUndo()) {
            const int index = stack().index();
            QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(stack().index() < index);
        }
        QCOMPARE(text(), m_before);
    }

private:
    const Asset& wall() { return project().assets.front(); }
    const RadialPattern& hole() { return std::get<RadialPattern>(wall().pattern.layers.back().parameters); }
    const Bake& bake() { return *window().workspace().bakes().find(wall().id)->bake; }
    bool isBaked() { return window().workspace().bakes().areCurrent(project()); }
    /// Triggers an action with the action search.
    void act(const QString& query) {
        window().activateWindow();
        QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QWidget* search = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((search = QApplication::activePopupWidget()), kPatience);
        auto* line = search->findChild<QLineEdit*>();
        QTest::keyClicks(line, query);
        QTest::keyClick(line, Qt::Key_Return);
    }

    std::uint32_t m_fragments = 0;
};

RUBBLE_TEST_WITH(ArtistStoryTest, QApplication)
#include "ArtistStoryTest.moc"
