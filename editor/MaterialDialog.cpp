#include "editor/MaterialDialog.h"

#include "editor/MaterialSheet.h"
#include "editor/PatternPreview.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr QSize kSwatch{28, 20};       // pixels
constexpr QSize kUsualSize{760, 560};  // pixels

QString textOf(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

QString materialFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/materials"; }

MaterialDialog::MaterialDialog(Document& document, Selection& selection, const QString& folder, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_selection(selection),
      m_library(materialLibrary(folder.toStdString())),
      m_folder(folder),
      m_list(new QListWidget),
      m_sheet(new QTextBrowser),
      m_preview(new PatternPreview) {
    setWindowTitle(tr("Material Library"));
    m_list->setIconSize(kSwatch);
    m_list->setAccessibleName(tr("Materials"));
    m_sheet->setAccessibleName(tr("Figures and sources"));
    auto* layout = new QGridLayout(this);
    layout->addWidget(m_list, 0, 0);
    layout->addWidget(m_preview, 1, 0);
    layout->addWidget(m_sheet, 0, 1, 2, 1);
    layout->addWidget(makeChoices(), 2, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(0, 1);
    connect(m_list, &QListWidget::currentRowChanged, this, &MaterialDialog::show);
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { (m_use->isEnabled() ? m_use : m_add)->click(); });
    fill();
    resize(kUsualSize);
    m_list->setFocus();
}

/// What is done with the chosen one, and what was wrong with files.
QWidget* MaterialDialog::makeChoices() {
    auto* choices = new QWidget;
    auto* layout = new QVBoxLayout(choices);
    layout->setContentsMargins(0, 0, 0, 0);
    m_takesPattern = new QCheckBox(tr("Break it in its usual &pattern"));
    m_takesPattern->setToolTip(tr("The asset's own layers, and what was merged, split or broken in its own way, go"));
    m_takesPattern->setChecked(true);
    m_derives = new QCheckBox(tr("Derive the &threshold from its strength"));
    m_derives->setToolTip(tr("Strength × smallest section × contact time, in place of the number that was typed"));
    layout->addWidget(m_takesPattern);
    layout->addWidget(m_derives);
    auto* place = new QLabel(tr("Presets of your own lie in %1").arg(QDir::toNativeSeparators(m_folder)));
    place->setTextInteractionFlags(Qt::TextSelectableByMouse);
    place->setWordWrap(true);
    place->setEnabled(false);
    layout->addWidget(place);
    for (const std::string& fault : m_library.faults) {
        auto* told = new QLabel(textOf(fault));
        told->setObjectName("fault");
        told->setWordWrap(true);
        layout->addWidget(told);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const QString name = asset() != nullptr ? textOf(asset()->name) : QString();
    m_use =
        buttons->addButton(name.isEmpty() ? tr("&Use") : tr("&Use for \"%1\"").arg(QString(name).replace('&', "&&")),
                           QDialogButtonBox::AcceptRole);
    m_use->setToolTip(tr("Copy it into the project and make the asset at hand of it"));
    m_add = buttons->addButton(tr("&Add to Project"), QDialogButtonBox::ActionRole);
    m_add->setToolTip(tr("Copy it into the project and change no asset"));
    connect(m_use, &QPushButton::clicked, this, &MaterialDialog::use);
    connect(m_add, &QPushButton::clicked, this, &MaterialDialog::add);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    return choices;
}

void MaterialDialog::fill() {
    for (const LibraryMaterial& material : m_library.materials) {
        auto* item = new QListWidgetItem(materialSwatch(material.preset), textOf(material.preset.name), m_list);
        item->setToolTip(textOf(material.preset.note));
    }
    const Asset* at = asset();
    const Material* own = at != nullptr ? findMaterial(m_document.project(), at->material) : nullptr;
    const LibraryMaterial* same = own != nullptr ? findMaterial(m_library, own->name) : nullptr;
    m_list->setCurrentRow(same != nullptr ? static_cast<int>(same - m_library.materials.data()) : 0);
}

const LibraryMaterial* MaterialDialog::chosen() const {
    const int row = m_list->currentRow();
    return row < 0 ? nullptr : &m_library.materials[static_cast<std::size_t>(row)];
}

const Asset* MaterialDialog::asset() const { return findAsset(m_document.project(), m_selection.asset()); }

void MaterialDialog::show(int) {
    const LibraryMaterial* material = chosen();
    if (material == nullptr) return;
    m_sheet->setHtml(materialSheet(*material, locale()));
    m_preview->setPreset(material->preset);
    m_use->setEnabled(asset() != nullptr);
    m_takesPattern->setEnabled(asset() != nullptr && !material->preset.pattern.layers.empty());
    m_derives->setEnabled(asset() != nullptr && material->preset.tensileStrength.has_value());
}

void MaterialDialog::use() {
    const LibraryMaterial* material = chosen();
    if (material == nullptr || asset() == nullptr) return;
    m_document.push(makeOf(m_document.project(), asset()->id, material->preset,
                           {.takesPattern = m_takesPattern->isChecked(), .derivesThreshold = m_derives->isChecked()}));
    accept();
}

void MaterialDialog::add() {
    const LibraryMaterial* material = chosen();
    if (material == nullptr) return;
    Addition addition = addMaterial(m_document.project(), material->preset);
    if (!addition.edit.isEmpty()) m_document.push(std::move(addition.edit));
    m_selection.setMaterial(addition.id);
    accept();
}

}  // namespace rubble
