#pragma once

#include "editor/workspace/Preferences.h"

#include <QDialog>

class QCheckBox;
class QComboBox;

namespace rubble {

class NumberField;
class PreferenceStore;

/// Edits the preferences. Changes apply at once; Cancel restores the previous ones.
class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    PreferencesDialog(PreferenceStore& store, QWidget* parent);
    /// Stays open while a field's text is refused.
    void accept() override;
    void reject() override;

private:
    void addFields();
    void showPreferences(const Preferences& preferences);
    void apply();

    PreferenceStore& m_store;
    Preferences m_before;
    QComboBox* m_theme = nullptr;
    QComboBox* m_unit = nullptr;
    QComboBox* m_navigation = nullptr;
    QCheckBox* m_smooth = nullptr;
    QComboBox* m_msaa = nullptr;
    QComboBox* m_refining = nullptr;
    QComboBox* m_quality = nullptr;
    NumberField* m_autosave = nullptr;
};

}  // namespace rubble
