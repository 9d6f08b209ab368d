#include "editor/panels/inspector/MortarSection.h"

#include "core/asset/checks/VerifyProject.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/BakedAssets.h"
#include "tests/support/editor/FailingWork.h"
#include "tests/support/editor/InspectorDesk.h"
#include "tests/support/play/MortarPortal.h"

#include <QCheckBox>
#include <QListWidget>
#include <QRegularExpression>
#include <QToolButton>

using namespace rubble;
using test::InspectorDesk;

namespace {

struct MortarDesk : InspectorDesk {
    explicit MortarDesk(Project project = test::mortarPortal()) : InspectorDesk(std::move(project)) {
        selection.setSubject(Part::Scene);
        inspector.resize(360, 1200);
    }
    MortarSection& section() { return *inspector.page().findChild<MortarSection*>(); }
    const std::vector<Mortar>& mortars() const { return document.project().mortars; }
    QListWidget& list() { return control<QListWidget>("Mortars"); }
    QListWidget& instances() { return control<QListWidget>("Joined Instances"); }
    QToolButton& button(const QString& name) { return control<QToolButton>(name); }
    QCheckBox& joinsAll() {
        for (auto* box : section().findChildren<QCheckBox*>()) return *box;
        qFatal("There is no check box.");
    }
    QString joints() { return section().findChild<QLabel*>("joints")->text(); }
    void rename(const QString& name) {
        auto& field = control<QLineEdit>("Name");
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, name);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    void clickRow(int row) {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(row)).center());
    }
};

}  // namespace

class MortarSectionTest : public QObject {
    Q_OBJECT
private slots:
    void isHiddenWithoutAnythingBonded() {
        MortarDesk plain(boxProject(UniformScatter{.count = 5}));
        QVERIFY(!plain.section().isVisible());
        QVERIFY(MortarDesk().section().isVisible());
    }
    void selectedMortarIsEdited() {
        MortarDesk desk;
        QVERIFY(!desk.control<QLineEdit>("Name").isVisible());
        desk.clickRow(0);
        QCOMPARE(desk.selection.mortar(), desk.mortars()[0].id);
        QVERIFY(desk.control<QLineEdit>("Name").isVisible());
        desk.type("Widest joint", "20 mm");
        desk.type("Least area", "0.01");
        desk.type("Impulse per area", "750");
        QCOMPARE(desk.mortars()[0].tolerance, 0.02);
        QCOMPARE(desk.mortars()[0].leastArea, 0.01);
        QCOMPARE(desk.mortars()[0].impulsePerArea, 750.0);
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.mortars(), test::mortarPortal().mortars);
    }
    void mortarsAreAddedNamedAndDeleted() {
        MortarDesk desk;
        desk.button("Add Mortar").click();
        QCOMPARE(desk.mortars().size(), std::size_t{2});
        QCOMPARE(desk.selection.mortar(), desk.mortars()[1].id);
        QCOMPARE(desk.list().count(), 2);
        QVERIFY(desk.list().item(1)->isSelected());
        desk.rename("joints");  // taken by the first
        QCOMPARE(desk.mortars()[1].name, std::string("mortar"));
        QCOMPARE(desk.refusals.count(), 1);
        desk.rename("wide joints");
        QCOMPARE(desk.list().item(1)->text(), QString("wide joints"));
        desk.button("Delete Mortar").click();
        QCOMPARE(desk.mortars().size(), std::size_t{1});
        QCOMPARE(desk.selection.mortar(), desk.mortars()[0].id);  // the neighbour
        desk.button("Delete Mortar").click();
        QVERIFY(desk.mortars().empty());
        QCOMPARE(desk.selection.mortar(), Id{0});
        QVERIFY(!desk.button("Delete Mortar").isEnabled());
        desk.undoAll();
        QCOMPARE(desk.mortars(), test::mortarPortal().mortars);
    }
    void nextMortarIsSelectedAfterADeletedOne() {
        MortarDesk desk;
        for (int k = 0; k < 2; ++k) desk.button("Add Mortar").click();
        const std::vector<Mortar> before = desk.mortars();
        desk.clickRow(1);
        desk.button("Delete Mortar").click();
        QCOMPARE(desk.selection.mortar(), before[2].id);
        QVERIFY(desk.list().item(1)->isSelected());
    }
    /// In a low inspector, the rows of a selected mortar are scrolled.
    void buttonsStayInPlaceWhenAMortarIsSelected() {
        MortarDesk desk;
        const auto place = [&] { return desk.button("Add Mortar").mapTo(&desk.inspector, QPoint()); };
        for (int height = 300; height <= 1200; height += 100) {
            desk.selection.setMortar(0);
            desk.inspector.resize(360, height);
            QCoreApplication::sendPostedEvents();
            const int before = place().x();
            desk.selection.setMortar(desk.mortars()[0].id);
            for (int k = 0; k < 3; ++k) QCoreApplication::processEvents();
            QCOMPARE(place().x(), before);
        }
    }
    void shortListHasRoomForThreeRows() {
        MortarDesk desk;
        QCOMPARE(desk.list().count(), 1);
        QVERIFY(desk.list().height() >= 3 * desk.list().sizeHintForRow(0));
    }
    void instancesAreChecked() {
        MortarDesk desk;
        desk.clickRow(0);
        QVERIFY(desk.joinsAll().isChecked() && !desk.instances().isVisible());
        desk.joinsAll().click();
        QCOMPARE(desk.mortars()[0].instances.size(), std::size_t{3});
        QCOMPARE(desk.instances().count(), 3);
        desk.instances().item(1)->setCheckState(Qt::Unchecked);
        const std::vector<Instance>& all = desk.document.project().instances;
        QCOMPARE(desk.mortars()[0].instances, (std::vector<Id>{all[0].id, all[2].id}));
        desk.instances().item(0)->setCheckState(Qt::Unchecked);
        desk.instances().item(2)->setCheckState(Qt::Unchecked);  // the last one
        QCOMPARE(desk.mortars()[0].instances, std::vector<Id>{all[2].id});
        QCOMPARE(desk.refusals.count(), 1);
        QCOMPARE(desk.instances().item(2)->checkState(), Qt::Checked);
        desk.joinsAll().click();
        QVERIFY(desk.mortars()[0].instances.empty());
        desk.undoAll();
        QCOMPARE(desk.mortars(), test::mortarPortal().mortars);
    }
    void jointsAreReported() {
        MortarDesk desk;
        desk.clickRow(0);
        QVERIFY(desk.joints().startsWith("Finding"));
        test::bakeAll(desk.document.project(), desk.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().contains("2 pair"), kPatience);
        QVERIFY2(desk.joints().contains(QRegularExpression("instances, 2.m²")), qPrintable(desk.joints()));
        for (Instance instance : desk.document.project().instances) {
            instance.isAnchored = false;
            desk.document.push(modify("Release", instance));
        }
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().contains("hold nothing"), kPatience);
        desk.type("Least area", "0.9");
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().startsWith("No faces"), kPatience);
    }
    /// An asset that cannot be fractured leaves the scene without joints: once, the section searched for ever.
    void searchThatFailsIsExplained() {
        MortarDesk desk;
        desk.clickRow(0);
        const Project& project = desk.document.project();
        test::bakeAll(project, desk.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().contains("2 pair"), kPatience);
        const auto asset = desk.bakes.find(project.instances[0].asset)->asset;
        desk.bakes.set(asset->id, std::make_shared<const BakedAsset>(
                                      BakedAsset{asset, nullptr, Error{ErrorCode::Limit, "Too many fragments."}, {}}));
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().contains("which is not baked yet"), kPatience);
        test::bakeAll(project, desk.bakes);
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().contains("2 pair"), kPatience);
        test::runOutOfMemory(desk.InspectorDesk::mortars);
        QTRY_VERIFY_WITH_TIMEOUT(desk.joints().startsWith(test::kOutOfMemory), kPatience);
    }
};

RUBBLE_TEST_WITH(MortarSectionTest, QApplication)
#include "MortarSectionTest.moc"
