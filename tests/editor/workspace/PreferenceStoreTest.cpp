#include "editor/workspace/PreferenceStore.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class PreferenceStoreTest : public QObject {
    Q_OBJECT
private slots:
    void setPreferencesAreStoredAndAnnouncedOnce() {
        const QTemporaryDir folder;
        test::keepSettingsIn(folder.path());
        PreferenceStore store;
        QSignalSpy changes(&store, &PreferenceStore::changed);
        const Preferences preferences{.unit = LengthUnit::Millimetre};
        store.setPreferences(preferences);
        store.setPreferences(preferences);
        QCOMPARE(changes.count(), 1);
        QVERIFY(PreferenceStore().preferences() == preferences);
    }
};

RUBBLE_TEST_WITH(PreferenceStoreTest, QCoreApplication)
#include "PreferenceStoreTest.moc"
