#include "editor/workspace/PreferenceStore.h"

namespace rubble {

PreferenceStore::PreferenceStore(QObject* parent) : QObject(parent), m_preferences(readPreferences(QSettings())) {}

void PreferenceStore::setPreferences(const Preferences& preferences) {
    if (preferences == m_preferences) return;
    m_preferences = preferences;
    QSettings settings;
    writePreferences(preferences, settings);
    emit changed();
}

}  // namespace rubble

#include "moc_PreferenceStore.cpp"
