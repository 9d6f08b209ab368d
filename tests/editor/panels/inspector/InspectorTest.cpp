#include "editor/panels/inspector/Inspector.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace rubble;
using test::InspectorDesk;

class InspectorTest : public QObject {
    Q_OBJECT
private slots:
    void pageFollowsTheSubject() {
        InspectorDesk desk;
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::AssetPage");
        desk.selection.setMaterial(2);
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::MaterialPage");
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::InstancePage");
        desk.selection.setSubject(Part::Scene);
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::ScenePage");
    }
    void showingChangesNothing() {
        InspectorDesk desk;
        for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Millimetre}) {
            desk.inspector.setUnits({unit});
            for (const Id asset : {3u, 9u, 11u}) desk.selection.setAsset(asset);
            for (const Id material : {1u, 2u}) desk.selection.setMaterial(material);
            desk.selection.setInstances(desk.document.project(), {21});
            for (int k = 0; k < 40; ++k) QTest::keyClick(desk.inspector.focusWidget(), Qt::Key_Tab);
            desk.selection.setSubject(Part::Scene);
            for (int k = 0; k < 40; ++k) QTest::keyClick(desk.inspector.focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(desk.document.undoStack().count(), 0);
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void invalidNamesAndNumbersAreRefused() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& name = desk.control<QLineEdit>("Name");
        name.setFocus();
        name.selectAll();
        QTest::keyClicks(&name, "wall");
        QTest::keyClick(&name, Qt::Key_Return);
        QCOMPARE(desk.refusals.count(), 1);
        QCOMPARE(desk.refusals[0][0], "The name \"wall\" is already taken.");
        QCOMPARE(name.text(), "box");
        desk.type("Depth", "0");
        desk.type("Width", "1e300");
        QCOMPARE(desk.document.undoStack().count(), 0);
        QCOMPARE(desk.control<NumberField>("Width").value(), 1.0);
    }
    void collapsedSectionsAreRestored() {
        InspectorDesk desk, next;
        for (auto* section : desk.inspector.findChildren<Section*>()) {
            QVERIFY(!section->isCollapsed());
            if (section->objectName() == "shape") section->setCollapsed(true);
        }
        QCOMPARE(desk.inspector.collapsedSections(), QStringList{"shape"});
        next.inspector.setCollapsedSections(desk.inspector.collapsedSections());
        QCOMPARE(next.inspector.collapsedSections(), QStringList{"shape"});
        next.inspector.setCollapsedSections({});
        QCOMPARE(next.inspector.collapsedSections(), QStringList{});
    }
    void undoingRandomEditsRestoresTheFile() {
        constexpr std::uint64_t kSeed = 2611;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        InspectorDesk desk;
        const auto below = [&](qsizetype count) {
            return static_cast<qsizetype>(random.below(static_cast<std::uint64_t>(count)));
        };
        for (int k = 0; k < 150; ++k) {
            switch (below(4)) {
                case 0: desk.selection.setAsset(std::array{3u, 9u, 11u}[static_cast<std::size_t>(below(3))]); break;
                case 1: desk.selection.setMaterial(1 + static_cast<Id>(below(2))); break;
                case 2: desk.selection.setInstances(desk.document.project(), {20, 21}); break;
                default: desk.selection.setSubject(Part::Scene); break;
            }
            const auto fields = desk.inspector.page().findChildren<NumberField*>();
            NumberField& field = *fields[below(fields.size())];
            if (!field.isVisible() || !field.isEnabled()) continue;
            field.setFocus();
            field.selectAll();
            QTest::keyClicks(&field, QString::number(random.unit() * 10.0 - 1.0));
            QTest::keyClick(&field, below(2) == 0 ? Qt::Key_Return : Qt::Key_Up);
            QVERIFY2(!verifyProject(desk.document.project()), qPrintable(field.accessibleName()));
        }
        QVERIFY(desk.document.undoStack().count() > 30);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void everyControlHasAToolTipAndIsReachableByKeyboard() {
        InspectorDesk desk;
        const auto check = [&] {
            for (QWidget* control : desk.inspector.page().findChildren<QWidget*>()) {
                if (!control->isVisible() || control->focusPolicy() == Qt::NoFocus || control->focusProxy()) continue;
                const bool isPart = qobject_cast<QAbstractSpinBox*>(control->parentWidget()) != nullptr;
                if (isPart) continue;
                const QByteArray name = control->metaObject()->className();
                QVERIFY2(!control->toolTip().isEmpty(), name + ' ' + control->accessibleName().toUtf8());
                const bool isButton = qobject_cast<QAbstractButton*>(control) != nullptr;
                QVERIFY2(isButton || !control->accessibleName().isEmpty(), name);
                QVERIFY2(control->focusPolicy() & Qt::TabFocus, name);
            }
        };
        check();
        desk.selection.setMaterial(1);
        check();
        desk.selection.setInstances(desk.document.project(), {20});
        check();
        desk.selection.setSubject(Part::Scene);
        check();
    }
};

RUBBLE_TEST_WITH(InspectorTest, QApplication)
#include "InspectorTest.moc"
