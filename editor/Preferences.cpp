#include "editor/Preferences.h"

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr const char* kTheme = "preferences/theme";
constexpr const char* kNavigation = "preferences/navigation";
constexpr const char* kUnit = "preferences/lengthUnit";
constexpr const char* kAutosave = "preferences/autosaveSeconds";
constexpr const char* kMsaa = "preferences/msaa";
constexpr const char* kRefining = "preferences/softLight";
constexpr const char* kSmooth = "preferences/smoothCamera";

constexpr std::array kThemeWords = {"system", "light", "dark"};
constexpr std::array kNavigationWords = {"blender", "maya"};
constexpr std::array kUnitWords = {"m", "cm", "mm"};
constexpr std::array kRefiningWords = {"never", "with-card", "always"};
constexpr std::array kMsaaSamples = {0, 1, 2, 4, 8};
constexpr int kLongestAutosaveSeconds = 3600;

/// The choice that a kept word stands for: words keep their meaning when choices are added.
template <class Choice, std::size_t Count>
Choice choiceOf(const QSettings& settings, const char* key, const std::array<const char*, Count>& words, Choice usual) {
    const QString kept = settings.value(key).toString();
    const auto word = std::ranges::find_if(words, [&](const char* candidate) { return kept == candidate; });
    return word == words.end() ? usual : static_cast<Choice>(word - words.begin());
}

int numberOf(const QSettings& settings, const char* key, int usual) {
    bool isNumber = false;
    const int number = settings.value(key).toInt(&isNumber);
    return isNumber ? number : usual;
}

}  // namespace

Preferences readPreferences(const QSettings& settings) {
    const Preferences usual;
    Preferences kept;
    kept.theme = choiceOf(settings, kTheme, kThemeWords, usual.theme);
    kept.navigation = choiceOf(settings, kNavigation, kNavigationWords, usual.navigation);
    kept.unit = choiceOf(settings, kUnit, kUnitWords, usual.unit);
    kept.autosaveSeconds = std::clamp(numberOf(settings, kAutosave, usual.autosaveSeconds), 0, kLongestAutosaveSeconds);
    kept.msaa = numberOf(settings, kMsaa, usual.msaa);
    if (std::ranges::find(kMsaaSamples, kept.msaa) == kMsaaSamples.end()) kept.msaa = usual.msaa;
    kept.refining = choiceOf(settings, kRefining, kRefiningWords, usual.refining);
    kept.isSmooth = settings.value(kSmooth, usual.isSmooth).toBool();
    return kept;
}

void writePreferences(const Preferences& preferences, QSettings& settings) {
    settings.setValue(kTheme, kThemeWords[static_cast<std::size_t>(preferences.theme)]);
    settings.setValue(kNavigation, kNavigationWords[static_cast<std::size_t>(preferences.navigation)]);
    settings.setValue(kUnit, kUnitWords[static_cast<std::size_t>(preferences.unit)]);
    settings.setValue(kAutosave, preferences.autosaveSeconds);
    settings.setValue(kMsaa, preferences.msaa);
    settings.setValue(kRefining, kRefiningWords[static_cast<std::size_t>(preferences.refining)]);
    settings.setValue(kSmooth, preferences.isSmooth);
}

}  // namespace rubble
