// Tests editor/widgets/NumberField.cpp and editor/widgets/numbers/UnitNames.cpp in the docks of a window.
#include "editor/panels/inspector/PatternEditor.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/TypedFields.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

#include <QLineEdit>
#include <QListView>
#include <QStatusBar>

#include <functional>
#include <set>

using namespace rubble;

/// Every field takes the units of its quantity, refuses others in the status bar, and follows the unit of length.
class NumberFieldsStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() { openBaked(fullProject()); }
    void cleanup() { preferences().setPreferences({}); }
    void cleanupTestCase() { close(); }

    void unitOfAnotherQuantityIsRefusedAndStays() {
        QStringList silent, dropped, familyless;
        const int count = forEachField([&](NumberField& field) {
            const QString name = field.accessibleName() + " (" + field.format().unit + ')';
            if (!field.format().unit.isEmpty() && field.format().family == UnitFamily::None) familyless << name;
            window().statusBar()->clearMessage();
            m_status.clear();
            type(field, "5 furlongs");
            if (!field.refusal().startsWith("\"5 furlongs\"") || m_status != field.refusal()) silent << name;
            if (field.findChild<QLineEdit*>()->text() != "5 furlongs") dropped << name;
            field.discardTyping();
        });
        QVERIFY2(count >= 60, qPrintable(QString::number(count)));
        QCOMPARE(familyless.join(", "), QString());
        QCOMPARE(silent.join(", "), QString());
        QCOMPARE(dropped.join(", "), QString());
        QCOMPARE(text(), m_before);
    }
    void allLengthsAreInThePreferredUnit() {
        preferences().setPreferences({.unit = LengthUnit::Foot});
        QStringList inMetres;
        std::set<QString> inFeet;
        forEachField([&](NumberField& field) {
            const UnitFamily family = field.format().family;
            if (family != UnitFamily::Length && family != UnitFamily::Area && family != UnitFamily::Volume) return;
            (field.format().unit.startsWith("ft") ? inFeet.insert(field.accessibleName()),
             void()                               : inMetres.append(field.accessibleName()));
        });
        QCOMPARE(inMetres.join(", "), QString());
        for (const char* name : {"Width", "Depth", "Radius", "Gap", "Height", "Position x"}) {
            QVERIFY2(inFeet.contains(name), name);
        }
    }

private:
    /// Calls `visit` with each field of all docks, for each kind of subject, and returns the number of fields.
    int forEachField(const std::function<void(NumberField&)>& visit) {
        int count = 0;
        std::set<QString> seen;
        const auto visitAll = [&](const QString& subject) {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // rows that were replaced
            for (NumberField* field : window().findChildren<NumberField*>()) {
                const QString name = subject + field->accessibleName() + field->format().unit;
                if (field->isHidden() || !seen.insert(name).second) continue;
                visit(*field);
                ++count;
            }
        };
        auto& patterns = *window().findChild<PatternEditor*>();
        for (const Asset& asset : project().assets) {
            selection().setAsset(asset.id);
            for (int row = 0; row < patterns.view().model()->rowCount(); ++row) {
                patterns.view().setCurrentIndex(patterns.view().model()->index(row, 0));
                visitAll("asset ");
            }
        }
        selection().setMaterial(2);
        visitAll("material ");
        selection().setInstances(project(), {project().instances.front().id});
        visitAll("instance ");
        selection().setSubject(Part::Scene);
        visitAll("scene ");
        return count;
    }
    void type(NumberField& field, const QString& text) {
        connect(&window().views(), &Views::statusMessage, this, &NumberFieldsStoryTest::keepStatus,
                Qt::UniqueConnection);
        auto* line = field.findChild<QLineEdit*>();
        line->setText(text);
        line->setModified(true);
        field.commit();
    }
    void keepStatus(const QString& sentence) { m_status = sentence; }

    QString m_status;
};

RUBBLE_TEST_WITH(NumberFieldsStoryTest, QApplication)
#include "NumberFieldsStoryTest.moc"
