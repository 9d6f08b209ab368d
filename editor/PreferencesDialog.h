#pragma once

#include "editor/Preferences.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace rubble {

class Program;

/// Asks for preferences. They take effect at once; Cancel brings those from before back.
class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    PreferencesDialog(Program& program, QWidget* parent);
    void reject() override;

private:
    void makeFields();
    void show(const Preferences& preferences);
    void apply();

    Program& m_program;
    Preferences m_before;
    QComboBox* m_theme = nullptr;
    QComboBox* m_unit = nullptr;
    QComboBox* m_navigation = nullptr;
    QCheckBox* m_smooth = nullptr;
    QComboBox* m_msaa = nullptr;
    QComboBox* m_refining = nullptr;
    QSpinBox* m_autosave = nullptr;
};

}  // namespace rubble
