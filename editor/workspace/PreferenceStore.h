#pragma once

#include "editor/workspace/Preferences.h"

#include <QObject>

namespace rubble {

/// Holds the preferences of the running program and keeps them in QSettings.
class PreferenceStore : public QObject {
    Q_OBJECT
public:
    explicit PreferenceStore(QObject* parent = nullptr);

    const Preferences& preferences() const { return m_preferences; }
    void setPreferences(const Preferences& preferences);

signals:
    void changed();

private:
    Preferences m_preferences;
};

}  // namespace rubble
