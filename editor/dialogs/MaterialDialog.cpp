#include "editor/dialogs/MaterialDialog.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "editor/dialogs/MaterialPictures.h"
#include "editor/dialogs/MaterialSummary.h"
#include "editor/dialogs/PatternPreview.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ScreenFit.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr QSize kMaterialDialogSize{760, 600};
constexpr int kNoteIndent = 24;                          // pixels, below the text of a check box
constexpr double kStoneMass = 0.05, kStoneSpeed = 20.0;  // kg and m/s, of a thrown stone

}  // namespace

QString materialFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/materials"; }

MaterialDialog::MaterialDialog(Document& document, Selection& selection, MaterialPictures& pictures,
                               const QString& folder, const Units& units, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_selection(selection),
      m_pictures(pictures),
      m_library(materialLibrary(toPath(folder))),
      m_folder(folder),
      m_units(units),
      m_list(new QListWidget),
      m_summary(new QTextBrowser),
      m_preview(new PatternPreview) {
    setWindowTitle(tr("Material Library"));
    m_list->setIconSize(kMaterialSwatchSize);
    m_list->setAccessibleName(tr("Materials"));
    m_summary->setAccessibleName(tr("Properties and sources"));
    auto* layout = new QGridLayout(this);
    layout->addWidget(m_list, 0, 0);
    layout->addWidget(m_preview, 1, 0);
    layout->addWidget(m_summary, 0, 1, 2, 1);
    layout->addWidget(createOptions(), 2, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(0, 1);
    connect(m_list, &QListWidget::currentRowChanged, this, &MaterialDialog::showSelected);
    connect(m_list, &QListWidget::itemDoubleClicked, this,
            [this] { (m_apply->isEnabled() ? m_apply : m_add)->click(); });
    fill();
    connect(&m_pictures, &MaterialPictures::pictureAdded, this, &MaterialDialog::showPictures);
    std::vector<MaterialPreset> presets;
    for (const LibraryMaterial& material : m_library.materials) presets.push_back(material.preset);
    m_pictures.render(presets, devicePixelRatioF());
    showPictures();
    resizeWithinScreen(*this, kMaterialDialogSize);
    m_list->setFocus();
}

/// Creates what is below the list: options, buttons, and errors of preset files.
QWidget* MaterialDialog::createOptions() {
    auto* options = new QWidget;
    auto* layout = new QVBoxLayout(options);
    layout->setContentsMargins(0, 0, 0, 0);
    m_appliesPattern = new QCheckBox;
    m_appliesPattern->setToolTip(
        tr("Replace the layers, merges and splits of the asset by the pattern of the material, and let it break "
           "where it is hit if the material does"));
    m_appliesPattern->setChecked(true);
    m_derivesThreshold = new QCheckBox(tr("Derive the &threshold from the strength"));
    m_derivesThreshold->setToolTip(
        tr("Compute the threshold from strength, thickness and contact time instead of using the entered one"));
    m_derivesThreshold->setChecked(asset() == nullptr || hasDefaultThreshold(*asset()));
    connect(m_derivesThreshold, &QCheckBox::toggled, this, &MaterialDialog::showThreshold);
    m_thresholdNote = new QLabel;
    m_thresholdNote->setObjectName("threshold-note");
    m_thresholdNote->setTextFormat(Qt::PlainText);
    m_thresholdNote->setWordWrap(true);
    m_thresholdNote->setIndent(kNoteIndent);
    layout->addWidget(m_appliesPattern);
    layout->addWidget(m_derivesThreshold);
    layout->addWidget(m_thresholdNote);
    auto* folder = new QLabel(tr("Preset folder: %1").arg(pathText(m_folder)));
    folder->setTextFormat(Qt::PlainText);
    folder->setTextInteractionFlags(Qt::TextSelectableByMouse);
    folder->setWordWrap(true);
    folder->setEnabled(false);
    layout->addWidget(folder);
    for (const std::string& error : m_library.errors) {
        auto* label = new QLabel(QString::fromStdString(error));
        label->setTextFormat(Qt::PlainText);
        label->setObjectName("error");
        label->setWordWrap(true);
        layout->addWidget(label);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const QString name = asset() != nullptr ? nameText(asset()->name) : QString();
    m_apply = buttons->addButton(name.isEmpty() ? tr("A&pply") : tr("A&pply to \"%1\"").arg(menuText(name)),
                                 QDialogButtonBox::AcceptRole);
    m_apply->setToolTip(tr("Add the material to the project and apply it to the active asset"));
    m_add = buttons->addButton(tr("&Add to Project"), QDialogButtonBox::ActionRole);
    m_add->setToolTip(tr("Add the material to the project only"));
    connect(m_apply, &QPushButton::clicked, this, &MaterialDialog::applyToAsset);
    connect(m_add, &QPushButton::clicked, this, &MaterialDialog::addToProject);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    return options;
}

void MaterialDialog::fill() {
    for (const LibraryMaterial& material : m_library.materials) {
        auto* item = new QListWidgetItem(materialSwatch(material.preset), nameText(material.preset.name), m_list);
        item->setToolTip(toolTipText(QString::fromStdString(printableText(material.preset.note))));
    }
    const Material* current = asset() ? findMaterial(m_document.project(), asset()->material) : nullptr;
    const LibraryMaterial* preset = current ? findMaterial(m_library, current->name) : nullptr;
    m_list->setCurrentRow(preset ? static_cast<int>(preset - m_library.materials.data()) : 0);
}

void MaterialDialog::showPictures() {
    for (int row = 0; row < m_list->count(); ++row) {
        const MaterialPreset& preset = m_library.materials[static_cast<std::size_t>(row)].preset;
        const QImage picture = m_pictures.picture(preset, devicePixelRatioF());
        if (picture.isNull()) continue;
        QIcon icon(QPixmap::fromImage(picture));
        icon.addPixmap(QPixmap::fromImage(picture), QIcon::Selected);  // otherwise Qt tints it in a selected row
        m_list->item(row)->setIcon(icon);
    }
}

const LibraryMaterial* MaterialDialog::selected() const {
    const int row = m_list->currentRow();
    return row < 0 ? nullptr : &m_library.materials[static_cast<std::size_t>(row)];
}

const Asset* MaterialDialog::asset() const { return findAsset(m_document.project(), m_selection.asset()); }

void MaterialDialog::showSelected() {
    const LibraryMaterial* material = selected();
    if (material == nullptr) return;
    m_summary->setHtml(materialSummary(*material, m_units, locale()));
    m_preview->setPreset(material->preset);
    m_apply->setEnabled(asset() != nullptr);
    const auto layers = asset() != nullptr ? static_cast<int>(asset()->pattern.layers.size()) : 0;
    m_appliesPattern->setText(layers == 0 ? tr("Apply the fracture &pattern")
                                          : tr("Apply the fracture &pattern in place of %n layer(s)", nullptr, layers));
    m_appliesPattern->setEnabled(asset() != nullptr && !material->preset.pattern.layers.empty());
    m_derivesThreshold->setEnabled(asset() != nullptr && material->preset.tensileStrength.has_value());
    showThreshold();
}

/// Says at what the active asset will break.
void MaterialDialog::showThreshold() {
    const LibraryMaterial* material = selected();
    m_thresholdNote->setVisible(material != nullptr && asset() != nullptr);
    if (material && asset()) m_thresholdNote->setText(thresholdNote(*asset(), material->preset));
}

QString MaterialDialog::thresholdNote(const Asset& asset, const MaterialPreset& preset) const {
    const auto text = [](double impulse) { return localizedQuantity(QuantityKind::Impulse, impulse); };
    const Material material = materialOf(preset, 0);
    const double before = thresholdOf(m_document.project(), asset);
    Asset changed = asset;
    if (m_derivesThreshold->isChecked()) deriveThresholdIfKnown(changed, material);
    const double after = thresholdOf(changed, material);
    const QString effect = after == before ? tr("It breaks at %1, as before.").arg(text(after))
                                           : tr("It will break at %1 instead of %2.").arg(text(after), text(before));
    const double stone = (1.0 + preset.restitution.value) * kStoneMass * kStoneSpeed;  // at what is held in place
    return effect + ' ' +
           (stone >= after ? tr("A thrown stone, 50 g at 20 m/s, breaks it.")
                           : tr("A thrown stone, 50 g at 20 m/s, does not break it."));
}

void MaterialDialog::applyToAsset() {
    const LibraryMaterial* material = selected();
    if (material == nullptr || asset() == nullptr) return;
    const bool isApplied = m_document.push(applyPreset(
        m_document.project(), asset()->id, material->preset,
        {.appliesPattern = m_appliesPattern->isChecked(), .derivesThreshold = m_derivesThreshold->isChecked()}));
    if (isApplied) accept();
}

void MaterialDialog::addToProject() {
    const LibraryMaterial* material = selected();
    if (material == nullptr) return;
    Addition addition = addMaterial(m_document.project(), material->preset);
    if (!m_document.push(std::move(addition.edit))) return;
    m_selection.setMaterial(addition.id);
    accept();
}

}  // namespace rubble

#include "moc_MaterialDialog.cpp"
