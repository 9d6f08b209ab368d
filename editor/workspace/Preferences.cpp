#include "editor/workspace/Preferences.h"

#include "core/asset/project/Ranges.h"
#include "editor/document/FilePath.h"

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr const char* kThemeKey = "preferences/theme";
constexpr const char* kNavigationKey = "preferences/navigation";
constexpr const char* kUnitKey = "preferences/lengthUnit";
constexpr const char* kAutosaveKey = "preferences/autosaveSeconds";
constexpr const char* kMsaaKey = "preferences/msaa";
constexpr const char* kRefiningKey = "preferences/softLight";
constexpr const char* kQualityKey = "preferences/quality";
constexpr const char* kSkyKey = "preferences/sky";
constexpr const char* kSkyFileKey = "preferences/skyFile";
constexpr const char* kSkyFilesKey = "preferences/recentSkyFiles";
constexpr const char* kExposureKey = "preferences/exposure";
constexpr const char* kSmoothKey = "preferences/smoothCamera";
constexpr const char* kStatisticsKey = "preferences/statistics";
constexpr const char* kSoundKey = "preferences/sound";
constexpr const char* kVolumeKey = "preferences/volume";

// Stored names, in the order of the enumerators: settings stay valid when enumerators are added.
constexpr std::array kThemeNames = {"system", "light", "dark"};
constexpr std::array kNavigationNames = {"blender", "maya"};
constexpr std::array kUnitNames = {"m", "cm", "mm", "ft"};
constexpr std::array kRefiningNames = {"never", "with-card", "always"};
constexpr std::array kQualityNames = {"draft", "good", "best"};
constexpr std::array kSkyNames = {"studio", "overcast", "morning", "evening", "night"};
constexpr std::array kMsaaSamples = {0, 1, 2, 4, 8};

/// Returns the enumerator whose stored name is set, or `fallback`.
template <class Enum, std::size_t Count>
Enum readEnum(const QSettings& settings, const char* key, const std::array<const char*, Count>& names, Enum fallback) {
    const QString stored = settings.value(key).toString();
    const auto name = std::ranges::find_if(names, [&](const char* candidate) { return stored == candidate; });
    return name == names.end() ? fallback : static_cast<Enum>(name - names.begin());
}

int readInt(const QSettings& settings, const char* key, int fallback) {
    bool isNumber = false;
    const int number = settings.value(key).toInt(&isNumber);
    return isNumber ? number : fallback;
}

}  // namespace

Preferences withLight(Preferences preferences, SkyPreset sky, const QString& file, double exposure) {
    preferences.sky = sky;
    preferences.skyFile = file;
    preferences.exposure = exposure;
    if (file.isEmpty() || preferences.recentSkyFiles.contains(file)) return preferences;
    preferences.recentSkyFiles.prepend(file);
    preferences.recentSkyFiles = preferences.recentSkyFiles.mid(0, kMaxSkyFiles);
    return preferences;
}

Preferences readPreferences(const QSettings& settings) {
    const Preferences defaults;
    Preferences stored;
    stored.theme = readEnum(settings, kThemeKey, kThemeNames, defaults.theme);
    stored.navigation = readEnum(settings, kNavigationKey, kNavigationNames, defaults.navigation);
    stored.unit = readEnum(settings, kUnitKey, kUnitNames, defaults.unit);
    stored.autosaveSeconds =
        std::clamp(readInt(settings, kAutosaveKey, defaults.autosaveSeconds), 0, kMaxAutosaveSeconds);
    stored.msaa = readInt(settings, kMsaaKey, defaults.msaa);
    if (std::ranges::find(kMsaaSamples, stored.msaa) == kMsaaSamples.end()) stored.msaa = defaults.msaa;
    stored.refining = readEnum(settings, kRefiningKey, kRefiningNames, defaults.refining);
    stored.quality = readEnum(settings, kQualityKey, kQualityNames, defaults.quality);
    stored.sky = readEnum(settings, kSkyKey, kSkyNames, defaults.sky);
    stored.skyFile = pathOf(settings.value(kSkyFileKey));
    for (const QVariant& path : settings.value(kSkyFilesKey).toList().mid(0, kMaxSkyFiles))
        stored.recentSkyFiles.append(pathOf(path));
    stored.exposure = settings.value(kExposureKey, defaults.exposure).toDouble();
    if (!rangeOf(ProjectNumber::Exposure).contains(stored.exposure)) stored.exposure = defaults.exposure;
    stored.isSmooth = settings.value(kSmoothKey, defaults.isSmooth).toBool();
    stored.hasStatistics = settings.value(kStatisticsKey, defaults.hasStatistics).toBool();
    stored.hasSound = settings.value(kSoundKey, defaults.hasSound).toBool();
    stored.volume = std::clamp(readInt(settings, kVolumeKey, defaults.volume), 0, kMaxVolume);
    return stored;
}

void writePreferences(const Preferences& preferences, QSettings& settings) {
    settings.setValue(kThemeKey, kThemeNames[static_cast<std::size_t>(preferences.theme)]);
    settings.setValue(kNavigationKey, kNavigationNames[static_cast<std::size_t>(preferences.navigation)]);
    settings.setValue(kUnitKey, kUnitNames[static_cast<std::size_t>(preferences.unit)]);
    settings.setValue(kAutosaveKey, preferences.autosaveSeconds);
    settings.setValue(kMsaaKey, preferences.msaa);
    settings.setValue(kRefiningKey, kRefiningNames[static_cast<std::size_t>(preferences.refining)]);
    settings.setValue(kQualityKey, kQualityNames[static_cast<std::size_t>(preferences.quality)]);
    settings.setValue(kSkyKey, kSkyNames[static_cast<std::size_t>(preferences.sky)]);
    settings.setValue(kSkyFileKey, settingOf(preferences.skyFile));
    QVariantList files;
    for (const QString& path : preferences.recentSkyFiles) files.append(settingOf(path));
    settings.setValue(kSkyFilesKey, files);
    settings.setValue(kExposureKey, preferences.exposure);
    settings.setValue(kSmoothKey, preferences.isSmooth);
    settings.setValue(kStatisticsKey, preferences.hasStatistics);
    settings.setValue(kSoundKey, preferences.hasSound);
    settings.setValue(kVolumeKey, preferences.volume);
}

}  // namespace rubble
