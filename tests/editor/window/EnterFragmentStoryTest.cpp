// Tests editor/actions/FragmentActions.cpp, editor/actions/SelectActions.cpp and editor/canvas/widget/Breadcrumb.cpp.
#include "core/asset/bake/FragmentLookup.h"
#include "editor/canvas/widget/Breadcrumb.h"
#include "editor/panels/docks/FragmentTable.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QStatusBar>
#include <QTableView>
#include <QToolButton>

using namespace rubble;

namespace {

/// A box of 1 m in four quarters, each of which a level fractures into four fragments.
Project quarters() {
    Project project =
        boxProject(PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}});
    project.assets[0].name = "Wall";
    const PlacedSeeds four{{{0, {-0.12, -0.12}}, {1, {0.12, -0.12}}, {2, {0.12, 0.12}}, {3, {-0.12, 0.12}}}};
    project.assets[0].levels = {{.pattern = {{{.id = 4, .parameters = four}}}}};
    return project;
}

}  // namespace

/// Entering and exiting fragments and editing their patterns, by mouse and keys.
class EnterFragmentStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(quarters());
        QVERIFY(isBaked(2, 20));
        canvas().setFocus();
    }
    void cleanupTestCase() { close(); }

    void doubleClickEntersFragment() {
        doubleClick(pixels({0.6, 0.6}));
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QCOMPARE(canvas().displayedPattern()->seeds().positions.size(), std::size_t{4});
        QVERIFY(breadcrumb().isVisible());
        QCOMPARE(breadcrumbTexts(), (QStringList{"Wall", "▸", "Fragment 3.2"}));
        QCOMPARE(levels().currentText(), QString("Fragments, level 1"));
        QCOMPARE(text(), m_before);
        QCOMPARE(stack().count(), 0);
    }
    void placedSeedGivesFragmentItsOwnPattern() {
        canvas().setTool(CanvasToolKind::PlaceSeeds);
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.0, 0.0}));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 21), kPatience);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(asset().fragmentLevels.size(), std::size_t{1});
        QCOMPARE(asset().fragmentLevels[0].fragment, FragmentPath("3.2"));
        QVERIFY(window().statusBar()->currentMessage().startsWith("Fragment 3.2 now has its own pattern."));
        QCOMPARE(levels().currentText(), QString("Fragment 3.2"));
        canvas().setTool(CanvasToolKind::Seeds);
    }
    void ownPatternIsUndoneInOneStep() {
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), m_before);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 20), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QCOMPARE(levels().currentText(), QString("Fragments, level 1"));
    }
    void lassoSelectsInCanvasTableAndView() {
        lasso({{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.02}, {-0.2, 0.02}});
        QVERIFY((selection().fragments() == FragmentSelection{{{4, 0}, {4, 1}}, std::nullopt, "3.2"}));
        QCOMPARE(selectedIds(), (QStringList{"2/3.2/4.0", "2/3.2/4.1"}));
        QTRY_COMPARE(table().view().selectionModel()->selectedRows().size(), 2);
        if (hasView()) QTRY_COMPARE(bodiesMarked(kSelected), 2);
    }
    void selectMenuWorksInsideFragment() {
        QTest::keyClick(&window(), Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(selectedIds(), (QStringList{"2/3.2/4.2", "2/3.2/4.3"}));
        QTest::keyClick(&window(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selectedIds().size(), 4);
        QTest::keyClick(&window(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(selection().fragments().isEmpty());
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.12, 0.12}));
        QTest::keyClick(&window(), Qt::Key_G, Qt::ControlModifier);
        QCOMPARE(selectedIds(), (QStringList{"2/3.2/4.1", "2/3.2/4.2", "2/3.2/4.3"}));
    }
    void rowSelectsSeedOfEnteredFragment() {
        clickRow("2/3.2/4.3");
        QVERIFY((selection().fragments() == FragmentSelection{{{4, 3}}, std::nullopt, "3.2"}));
        QVERIFY((selection().seeds() == Selection::Seeds{{4, 3}}));
        clickRow("2/3.1");
        QVERIFY(selection().seeds().empty());  // it is in another fragment
        QCOMPARE(selectedIds(), QStringList{"2/3.1"});
    }
    void shortcutsExitAndEnter() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 2}}));  // the fragment that was exited
        QVERIFY(!breadcrumb().isVisible());
        QVERIFY(!action("fragment-exit")->isEnabled());
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QVERIFY(selection().fragments().isEmpty());
        QCOMPARE(text(), m_before);  // the arrow keys moved no seed
    }
    void doubleClickOnUnfracturedFragmentSelectsIt() {
        const int steps = stack().index();
        doubleClick(pixels({0.0, 0.05}));
        QVERIFY(isEntered("3.2"));
        QCOMPARE(stack().index(), steps);
        QCOMPARE(selection().seeds().size(), std::size_t{1});
        selection().setSeeds({});
    }
    void exitRestoresTheView() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        const CanvasView fitted = canvas().view();
        canvas().zoomBy(1.7);
        const CanvasView near = canvas().view();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QVERIFY(canvas().view() != near);  // the fragment is framed
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        QVERIFY(canvas().view() == near);
        canvas().fit();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        QVERIFY(canvas().view() == fitted);
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
    }
    void unfracturedFragmentIsNotEntered() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.12, 0.12}));
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY(isEntered("3.2"));
        QVERIFY(window().statusBar()->currentMessage().startsWith("Fragment 3.2/4.2 is not fractured."));
        QCOMPARE(text(), m_before);

        QTest::keyClick(&window(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(asset().fragmentLevels[0].fragment, FragmentPath("3.2/4.2"));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 25), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2/4.2"), kPatience);
        QCOMPARE(breadcrumbTexts(), (QStringList{"Wall", "▸", "Fragment 3.2", "▸", "Fragment 4.2"}));
        QCOMPARE(canvas().displayedPattern()->partition().pieceCount(), 5u);
    }
    void removedFragmentIsExitedToNearestAncestor() {
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2"), kPatience);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 25), kPatience);
        QVERIFY(isEntered("3.2"));
    }
    void clickOnBreadcrumbExits() {
        doubleClick(pixels({0.05, 0.05}));
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.2/4.2"), kPatience);
        QList<QToolButton*> buttons = breadcrumb().findChildren<QToolButton*>();
        erase_if(buttons, [](const QToolButton* button) { return button->isHidden(); });
        QCOMPARE(buttons.size(), 2);
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 2}}));
    }
    void enterOnChildFragmentEntersItsParent() {
        clickRow("2/3.0/4.1");
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.0"), kPatience);
        QVERIFY((selection().fragments() == FragmentSelection{{{4, 1}}, std::nullopt, "3.0"}));
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
    }
    void activatingAnotherAssetExits() {
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered("3.0"), kPatience);
        QTest::keyClick(&window(), Qt::Key_D, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(selection().asset() != 2, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        QVERIFY(!breadcrumb().isVisible());
    }
    void severalFragmentsAreNotEnteredButSaySo() {
        selection().setAsset(2);
        QTRY_VERIFY_WITH_TIMEOUT(isEntered(""), kPatience);
        lasso({{0.05, 0.05}, {0.95, 0.05}, {0.95, 0.4}, {0.05, 0.4}});
        QCOMPARE(selectedIds().size(), 2);
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY(isEntered(""));
        QVERIFY(window().statusBar()->currentMessage().contains("double-click it in the canvas"));
    }
    void fractureAgainIsSeenInTheCanvas() {
        clickRow("2/3.0/4.1");  // a child of what the canvas shows
        canvas().setOverlays({});
        const QImage before = canvas().grab().toImage();
        const std::uint32_t fragments = bake().fragmentCount();
        action("fragment-fracture")->trigger();
        QCOMPARE(asset().fragmentLevels.back().fragment, FragmentPath("3.2/4.2"));
        QCOMPARE(asset().fragmentLevels.front().fragment, FragmentPath("3.0/4.1"));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, fragments + 5), kPatience);
        QVERIFY(canvas().overlays().hasDeeperLevels);
        QTRY_VERIFY(canvas().grab().toImage() != before);
        stack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, fragments), kPatience);
    }
    void fragmentsOfDifferentParentsAreNotMerged() {
        FragmentSet set(bake().fragmentCount(), false);
        for (const char* path : {"3.0/4.1", "3.1/4.0"}) set[*fragmentAt(bake(), path)] = true;
        selection().setFragments(selectionOf(set, bake()));
        const int steps = stack().index();
        action("fragment-merge")->trigger();
        QCOMPARE(stack().index(), steps);
        QVERIFY(window().statusBar()->currentMessage().contains("different parents"));
    }

private:
    const Asset& asset() { return *findAsset(project(), 2); }
    bool isEntered(const FragmentPath& path) {
        const DrawablePattern* shown = canvas().displayedPattern();
        return selection().enteredFragment() == path && shown && shown->baked().parent == path;
    }
    void doubleClick(QPoint at) {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at);
    }
    const Bake& bake() { return *window().workspace().bakes().find(2)->bake; }
    QStringList selectedIds() {
        QStringList ids;
        const FragmentSet set = fragmentsOf(selection().fragments(), bake());
        for (std::uint32_t k = 0; k < set.size(); ++k) {
            if (set[k]) ids.append(QString::fromStdString(bake().fragmentId(k)));
        }
        ids.sort();
        return ids;
    }
    Breadcrumb& breadcrumb() { return *window().findChild<Breadcrumb*>(); }
    QStringList breadcrumbTexts() {
        QStringList texts;
        for (int k = 0; k < breadcrumb().layout()->count(); ++k) {
            const QWidget* widget = breadcrumb().layout()->itemAt(k)->widget();
            const auto* label = qobject_cast<const QLabel*>(widget);
            texts.append(label ? label->text() : static_cast<const QToolButton*>(widget)->text());
        }
        return texts;
    }
    QComboBox& levels() {
        for (QComboBox* box : window().findChildren<QComboBox*>()) {
            if (box->accessibleName() == "Pattern") return *box;
        }
        qFatal("There is no list of patterns.");
    }
    FragmentTable& table() { return *window().findChild<FragmentTable*>(); }
    void clickRow(const QString& id) {
        QTableView& view = table().view();
        const QModelIndexList found =
            view.model()->match(view.model()->index(0, 0), Qt::DisplayRole, id, 1, Qt::MatchExactly);
        QVERIFY2(!found.isEmpty(), qPrintable(id));
        view.scrollTo(found.front());
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.visualRect(found.front()).center());
    }
};

RUBBLE_TEST_WITH(EnterFragmentStoryTest, QApplication)
#include "EnterFragmentStoryTest.moc"
