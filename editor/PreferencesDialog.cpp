#include "editor/PreferencesDialog.h"

#include "editor/ChoiceBox.h"
#include "editor/Program.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

#include <bit>

namespace rubble {

PreferencesDialog::PreferencesDialog(Program& program, QWidget* parent)
    : QDialog(parent), m_program(program), m_before(program.preferences()) {
    setWindowTitle(tr("Preferences"));
    makeFields();
    show(m_before);
    for (QComboBox* box : {m_theme, m_unit, m_navigation, m_msaa, m_refining}) {
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::apply);
    }
    connect(m_smooth, &QCheckBox::toggled, this, &PreferencesDialog::apply);
    connect(m_autosave, &QSpinBox::valueChanged, this, &PreferencesDialog::apply);
}

void PreferencesDialog::makeFields() {
    m_theme =
        choiceBox({tr("As the desktop"), tr("Light"), tr("Dark")}, tr("The colours of windows, canvas and 3D view"));
    m_unit = choiceBox({tr("Metres"), tr("Centimetres"), tr("Millimetres")},
                       tr("In what lengths are shown and typed; files hold metres always"));
    m_navigation =
        choiceBox({tr("Like Blender: middle button turns, Shift moves"), tr("Like Maya: Alt and the buttons")},
                  tr("How the mouse moves the 3D view"));
    m_smooth = new QCheckBox(tr("Move smoothly to another view"));
    m_smooth->setToolTip(tr("The 3D view glides to a new place instead of jumping"));
    m_msaa = choiceBox({tr("Automatic"), tr("Off"), tr("2×"), tr("4×"), tr("8×")},
                       tr("Smooth edges in the 3D view; automatic is 4×, and off without a graphics card"));
    m_refining = choiceBox({tr("Never"), tr("With a graphics card"), tr("Always")},
                           tr("Light and edges of the 3D view become softer while nothing moves"));
    m_autosave = new QSpinBox;
    m_autosave->setRange(0, 3600);
    m_autosave->setSuffix(tr(" s"));
    m_autosave->setSpecialValueText(tr("Never"));
    m_autosave->setToolTip(tr("How long after a change a backup is written, never over the project itself"));
    auto* buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] { show({}); });

    auto* form = new QFormLayout(this);
    form->addRow(tr("&Theme:"), m_theme);
    form->addRow(tr("&Lengths in:"), m_unit);
    form->addRow(tr("&Navigation:"), m_navigation);
    form->addRow(QString(), m_smooth);
    form->addRow(tr("&Smooth edges:"), m_msaa);
    form->addRow(tr("So&ft light:"), m_refining);
    form->addRow(tr("&Backup after:"), m_autosave);
    form->addRow(buttons);
}

void PreferencesDialog::show(const Preferences& preferences) {
    m_theme->setCurrentIndex(static_cast<int>(preferences.theme));
    m_unit->setCurrentIndex(static_cast<int>(preferences.unit));
    m_navigation->setCurrentIndex(static_cast<int>(preferences.navigation));
    m_smooth->setChecked(preferences.isSmooth);
    m_msaa->setCurrentIndex(std::bit_width(static_cast<unsigned>(preferences.msaa)));
    m_refining->setCurrentIndex(static_cast<int>(preferences.refining));
    m_autosave->setValue(preferences.autosaveSeconds);
}

void PreferencesDialog::apply() {
    Preferences chosen;
    chosen.theme = static_cast<ThemeChoice>(m_theme->currentIndex());
    chosen.unit = static_cast<LengthUnit>(m_unit->currentIndex());
    chosen.navigation = static_cast<NavigationChoice>(m_navigation->currentIndex());
    chosen.isSmooth = m_smooth->isChecked();
    chosen.msaa = (1 << m_msaa->currentIndex()) / 2;  // 0, 1, 2, 4, 8
    chosen.refining = static_cast<Refining>(m_refining->currentIndex());
    chosen.autosaveSeconds = m_autosave->value();
    m_program.setPreferences(chosen);
}

void PreferencesDialog::reject() {
    m_program.setPreferences(m_before);
    QDialog::reject();
}

}  // namespace rubble
