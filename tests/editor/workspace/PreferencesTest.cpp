#include "editor/workspace/Preferences.h"
#include "editor/workspace/RecentFiles.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace rubble;

class PreferencesTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        test::keepSettingsIn(m_folder->path());
    }

    void writtenPreferencesAreReadBack() {
        const Preferences preferences{.theme = ColourScheme::Dark,
                                      .navigation = NavigationStyle::Maya,
                                      .unit = LengthUnit::Millimetre,
                                      .autosaveSeconds = 0,
                                      .msaa = 8,
                                      .refining = ProgressiveRendering::Always,
                                      .quality = RenderQuality::Best,
                                      .sky = SkyPreset::Evening,
                                      .skyFile = "/skies/dusk.hdr",
                                      .recentSkyFiles = {"/skies/dusk.hdr", "/skies/noon.hdr"},
                                      .exposure = -1.5,
                                      .isSmooth = false,
                                      .hasStatistics = true,
                                      .hasSound = true,
                                      .volume = 25};
        QSettings settings;
        writePreferences(preferences, settings);
        QVERIFY(readPreferences(settings) == preferences);
    }
    void invalidValuesGetTheirDefaults() {
        QSettings settings;
        QVERIFY(readPreferences(settings) == Preferences{});
        settings.setValue("preferences/theme", "purple");
        settings.setValue("preferences/msaa", 3);
        settings.setValue("preferences/autosaveSeconds", "often");
        settings.setValue("preferences/sky", "green");
        settings.setValue("preferences/quality", "excellent");
        settings.setValue("preferences/exposure", "nan");
        settings.setValue("preferences/volume", "loud");
        QVERIFY(readPreferences(settings) == Preferences{});
        settings.setValue("preferences/volume", 300);
        QCOMPARE(readPreferences(settings).volume, 100);
    }
    void lastSkyFilesAreKept() {
        Preferences preferences;
        for (const char* name : {"a", "b", "c", "a", "d", "e", "f", "g"})
            preferences = withLight(preferences, SkyPreset::Studio, name, 0.5);
        QCOMPARE(preferences.skyFile, QString("g"));
        QCOMPARE(preferences.recentSkyFiles, QStringList({"g", "f", "e", "d", "c", "b"}));
        preferences = withLight(preferences, SkyPreset::Night, {}, 1.0);
        QVERIFY(preferences.skyFile.isEmpty() && preferences.recentSkyFiles.size() == kMaxSkyFiles);
        QCOMPARE(preferences.exposure, 1.0);
    }
    void recentFilesExistAndAreNewestFirst() {
        RecentFiles recent;
        for (int k = 0; k < RecentFiles::kMaxCount + 3; ++k) {
            const QString path = m_folder->filePath(QString("%1.rubble").arg(k));
            QVERIFY(QFile(path).open(QIODevice::WriteOnly));
            recent.add(path);
        }
        recent.add(m_folder->filePath("5.rubble"));
        recent.add(m_folder->filePath("gone.rubble"));
        const QStringList paths = RecentFiles().paths();
        QCOMPARE(paths.size(), RecentFiles::kMaxCount - 1);
        QCOMPARE(paths.first(), m_folder->filePath("5.rubble"));
        QCOMPARE(paths.count(m_folder->filePath("5.rubble")), 1);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(PreferencesTest, QCoreApplication)
#include "PreferencesTest.moc"
