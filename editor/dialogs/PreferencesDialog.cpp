#include "editor/dialogs/PreferencesDialog.h"

#include "editor/widgets/ComboBox.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/TypedFields.h"
#include "editor/workspace/PreferenceStore.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include <bit>

namespace rubble {

PreferencesDialog::PreferencesDialog(PreferenceStore& store, QWidget* parent)
    : QDialog(parent), m_store(store), m_before(store.preferences()) {
    setWindowTitle(tr("Preferences"));
    addFields();
    showPreferences(m_before);
    for (QComboBox* box : {m_theme, m_unit, m_navigation, m_msaa, m_refining, m_quality}) {
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::apply);
    }
    connect(m_smooth, &QCheckBox::toggled, this, &PreferencesDialog::apply);
    connect(m_autosave, &NumberField::edited, this, &PreferencesDialog::apply);
}

void PreferencesDialog::addFields() {
    m_theme = comboBox({tr("System"), tr("Light"), tr("Dark")}, tr("Select the colours of all windows"));
    m_unit = comboBox({tr("Metres"), tr("Centimetres"), tr("Millimetres"), tr("Feet")},
                      tr("Select the unit of length for all windows; files use metres"));
    m_navigation =
        comboBox({tr("Blender: middle button orbits, Shift+middle button pans"), tr("Maya: Alt and mouse buttons")},
                 tr("Select the mouse controls of the 3D view"));
    m_smooth = new QCheckBox(tr("S&mooth view changes"));
    m_smooth->setToolTip(tr("Move the camera smoothly instead of jumping"));
    m_msaa =
        comboBox({tr("Automatic"), tr("Off"), tr("2×"), tr("4×"), tr("8×")},
                 tr("Select the anti-aliasing of the 3D view; automatic means 4× with a graphics card, none without"));
    m_refining = comboBox({tr("Never"), tr("With a graphics card"), tr("Always")},
                          tr("Refine light and edges of the 3D view while nothing moves"));
    m_quality = comboBox({tr("Draft"), tr("Good"), tr("Best")},
                         tr("Select how far the 3D view is refined while nothing moves; draft: not at all"));
    m_quality->setObjectName("view-quality");
    m_autosave = new NumberField;
    m_autosave->setRange(FieldRange::whole(0, kMaxAutosaveSeconds));
    m_autosave->setFormat(Units::seconds());
    m_autosave->setHint(tr("Set the delay between a change and its backup; 0 for no backups"));
    auto* buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
        showPreferences({});
        apply();
    });

    auto* form = new QFormLayout(this);
    form->addRow(tr("&Theme:"), m_theme);
    form->addRow(tr("&Unit of length:"), m_unit);
    form->addRow(tr("&Navigation:"), m_navigation);
    form->addRow(QString(), m_smooth);
    form->addRow(tr("&Anti-aliasing:"), m_msaa);
    form->addRow(tr("So&ft light:"), m_refining);
    form->addRow(tr("&Quality at rest:"), m_quality);
    form->addRow(tr("&Back up changes after:"), m_autosave);
    form->addRow(buttons);
}

void PreferencesDialog::showPreferences(const Preferences& preferences) {
    m_theme->setCurrentIndex(static_cast<int>(preferences.theme));
    m_unit->setCurrentIndex(static_cast<int>(preferences.unit));
    m_navigation->setCurrentIndex(static_cast<int>(preferences.navigation));
    m_smooth->setChecked(preferences.isSmooth);
    m_msaa->setCurrentIndex(std::bit_width(static_cast<unsigned>(preferences.msaa)));
    m_refining->setCurrentIndex(static_cast<int>(preferences.refining));
    m_quality->setCurrentIndex(static_cast<int>(preferences.quality));
    m_autosave->setValue(preferences.autosaveSeconds);
}

void PreferencesDialog::apply() {
    Preferences preferences = m_store.preferences();  // some are set elsewhere
    preferences.theme = static_cast<ColourScheme>(m_theme->currentIndex());
    preferences.unit = static_cast<LengthUnit>(m_unit->currentIndex());
    preferences.navigation = static_cast<NavigationStyle>(m_navigation->currentIndex());
    preferences.isSmooth = m_smooth->isChecked();
    preferences.msaa = (1 << m_msaa->currentIndex()) / 2;  // 0, 1, 2, 4, 8
    preferences.refining = static_cast<ProgressiveRendering>(m_refining->currentIndex());
    preferences.quality = static_cast<RenderQuality>(m_quality->currentIndex());
    preferences.autosaveSeconds = static_cast<int>(m_autosave->value());
    m_store.setPreferences(preferences);
}

void PreferencesDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

void PreferencesDialog::reject() {
    m_store.setPreferences(m_before);
    QDialog::reject();
}

}  // namespace rubble

#include "moc_PreferencesDialog.cpp"
