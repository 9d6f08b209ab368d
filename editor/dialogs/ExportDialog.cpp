#include "editor/dialogs/ExportDialog.h"

#include "core/io/formats/ExportFormat.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/SceneFile.h"
#include "editor/dialogs/ExportTree.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/ScreenFit.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kDescriptionLines = 2;          // of the longest one
constexpr QSize kExportDialogSize{800, 540};  // pixels, so that a path and file names fit

/// A text of the rows of formats, options and programs.
QString exportText(std::string_view text) { return QCoreApplication::translate("Export", std::string(text).c_str()); }

QCheckBox* checkBox(const QString& text, const QString& toolTip) {
    auto* box = new QCheckBox(text);
    box->setToolTip(toolTip);
    return box;
}

}  // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), m_workspace(workspace) {
    setWindowTitle(tr("Export"));
    addFields();
    addForm();
    showOptions(lastExportOptions(workspace).value_or(ExportOptions{.folder = defaultExportFolder(workspace)}));
    connect(m_target, &QComboBox::currentIndexChanged, this, &ExportDialog::applyTarget);
    for (const auto& [format, box] : m_formats) connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    for (const auto& [option, box] : m_options)
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    connect(m_contents, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    connect(m_assets, &QListWidget::itemChanged, this, &ExportDialog::refresh);
    connect(m_folder, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    refresh();
    m_target->setFocus();  // what is usually set; its first letters select a program
}

void ExportDialog::addFields() {
    m_assets = new QListWidget;
    m_assets->setAccessibleName(tr("Assets to export"));
    m_assets->setToolTip(tr("Select the assets to export; each is written to a folder with its name"));
    m_contents = comboBox({tr("Assets and scene"), tr("Assets only")},
                          tr("Select whether scene.json is written beside all assets; it has the instances, the "
                             "ground and the saved throws"));
    m_folder = new QLineEdit;
    m_folder->setToolTip(tr("Set the output folder, which gets a subfolder for each asset"));
    QStringList programs;
    for (const ExportTarget& target : exportTargets()) programs.append(exportText(target.title));
    m_target =
        comboBox(programs, tr("Select the program that the export is for; a README.md says how to use it there"));
    m_description = new QLabel;
    m_description->setObjectName("program-description");
    m_description->setWordWrap(true);
    m_description->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_description->setMinimumHeight(kDescriptionLines * m_description->fontMetrics().lineSpacing());
    for (const ExportFormat* format : exportFormats())
        m_formats.emplace_back(format, checkBox(exportText(format->caption), exportText(format->hint)));
    for (const ExportOption* option : exportOptions()) {
        if (option->caption.empty()) continue;
        QStringList texts;
        for (const ExportOption::Value& value : option->values) texts.append(exportText(value.text));
        m_options.emplace_back(option, comboBox(texts, exportText(option->hint)));
    }
    m_onSave = checkBox(tr("Export again &whenever the project is saved"),
                        tr("Repeat this export in the background after each save of the project's file"));
    m_tree = new ExportTree;
    m_problem = new QLabel;
    m_problem->setWordWrap(true);
}

void ExportDialog::addForm() {
    auto* layout = new QVBoxLayout(this);
    auto* columns = new QHBoxLayout;
    layout->addLayout(columns);
    auto* form = new QFormLayout;
    addOptions(*form);
    columns->addLayout(form, 1);
    auto* output = new QVBoxLayout;
    output->addWidget(new QLabel(tr("Output:")));
    output->addWidget(m_tree, 1);
    output->addWidget(m_problem);
    columns->addLayout(output, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    m_export->setDefault(true);  // after the button was added to the dialog
    resizeWithinScreen(*this, kExportDialogSize.expandedTo(minimumSizeHint()));
}

void ExportDialog::addOptions(QFormLayout& form) {
    if (QWidget* targets = createTargets()) form.addRow(buddyLabel(tr("Ea&rlier exports:"), m_targetList), targets);
    form.addRow(tr("&Assets:"), m_assets);
    form.addRow(tr("Co&ntents:"), m_contents);
    form.addRow(buddyLabel(tr("&Folder:"), m_folder), createPathRow(*m_folder, [this] { browse(); }));
    form.addRow(tr("&Program:"), m_target);
    form.addRow(QString(), m_description);
    form.addRow(tr("Meshes:"), createFormats());
    for (const auto& [option, box] : m_options) form.addRow(exportText(option->caption), box);
    form.addRow(m_onSave);
}

QGridLayout* ExportDialog::createFormats() const {
    constexpr int kRows = 2;
    auto* formats = new QGridLayout;
    for (int k = 0; const auto& [format, box] : m_formats) {
        formats->addWidget(box, k % kRows, k / kRows);
        ++k;
    }
    return formats;
}

/// The list of earlier exports; null where there is at most the one that is shown anyway.
QWidget* ExportDialog::createTargets() {
    m_targets = earlierExports(m_workspace);
    if (m_targets.size() < 2) return nullptr;
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_targetList = new QComboBox;
    m_targetList->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_targetList->setMinimumContentsLength(1);
    m_targetList->setToolTip(tr("Show the options of an export of this project; Export Again repeats all of them"));
    auto* forget = new QPushButton(tr("Forget"));
    forget->setAutoDefault(false);
    forget->setToolTip(tr("Let Export Again leave this export out; its files stay"));
    layout->addWidget(m_targetList, 1);
    layout->addWidget(forget);
    listTargets();
    connect(m_targetList, &QComboBox::activated, this, [this](int index) {
        showOptions(m_targets[static_cast<std::size_t>(index)]);
        refresh();
    });
    connect(forget, &QPushButton::clicked, this, &ExportDialog::forgetTarget);
    return row;
}

/// Lists the targets, the last one selected.
void ExportDialog::listTargets() {
    m_targetList->clear();
    for (const ExportOptions& target : m_targets)
        m_targetList->addItem(exportText(target.target->title) + " · " + pathText(target.folder));
    m_targetList->setCurrentIndex(m_targetList->count() - 1);
}

void ExportDialog::forgetTarget() {
    const int index = m_targetList->currentIndex();
    if (index < 0) return;
    forgetExport(m_workspace, m_targets[static_cast<std::size_t>(index)].folder);
    m_targets = earlierExports(m_workspace);
    listTargets();
    if (m_targets.empty()) return m_targetList->parentWidget()->setEnabled(false);
    showOptions(m_targets.back());
    refresh();
}

void ExportDialog::showOptions(const ExportOptions& options) {
    m_assets->clear();
    for (const Asset& asset : m_workspace.project().assets) {
        auto* item = new QListWidgetItem(nameText(asset.name), m_assets);
        item->setData(Qt::UserRole, asset.id);
        const bool isSelected =
            !options.assets || std::ranges::find(*options.assets, asset.id) != options.assets->end();
        item->setCheckState(isSelected ? Qt::Checked : Qt::Unchecked);
    }
    m_folder->setText(QDir::toNativeSeparators(options.folder));
    m_contents->setCurrentIndex(options.isWithScene ? 0 : 1);
    m_onSave->setChecked(options.isRepeatedOnSave);
    m_target->setCurrentIndex(static_cast<int>(options.target - exportTargets().data()));
    showFiles(options.pack);
}

void ExportDialog::showFiles(const PackOptions& pack) {
    for (const auto& [format, box] : m_formats) box->setChecked(pack.meshes.formats.contains(format->word));
    for (const auto& [option, box] : m_options) box->setCurrentIndex(static_cast<int>(option->get(pack)));
}

std::vector<Id> ExportDialog::selectedAssets() const {
    std::vector<Id> selected;
    for (int row = 0; row < m_assets->count(); ++row) {
        const QListWidgetItem* item = m_assets->item(row);
        if (item->checkState() == Qt::Checked) selected.push_back(item->data(Qt::UserRole).toUInt());
    }
    return selected;
}

ExportOptions ExportDialog::options() const {
    ExportOptions options{.folder = QDir::fromNativeSeparators(m_folder->text())};
    std::vector<Id> selected = selectedAssets();
    const bool areAll = static_cast<int>(selected.size()) == m_assets->count();
    if (!areAll) options.assets = std::move(selected);  // all: includes assets that are added later
    options.isWithScene = m_contents->currentIndex() == 0;
    options.isRepeatedOnSave = m_onSave->isChecked();
    options.target = &exportTargets()[static_cast<std::size_t>(m_target->currentIndex())];
    options.pack = options.target->options();
    options.pack.meshes.formats = {};
    for (const auto& [format, box] : m_formats) {
        if (box->isChecked()) options.pack.meshes.formats.insert(format->word);
    }
    for (const auto& [option, box] : m_options)
        option->set(options.pack, static_cast<std::size_t>(std::max(0, box->currentIndex())));
    return options;
}

void ExportDialog::browse() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Export Folder"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(QDir::toNativeSeparators(folder));
}

/// Whether an export to the folder would replace one for another program. Without a saved project, what a default
/// folder holds is not known to be for the same program.
bool ExportDialog::isOfOtherProgram(const QString& folder, const ExportTarget* target) const {
    const auto known = std::ranges::find(m_targets, folder, &ExportOptions::folder);
    if (known != m_targets.end()) return known->target != target;
    return folder.startsWith(defaultExportFolder(m_workspace)) && QFile::exists(folder + '/' + kIndexName);
}

/// The folder of the last export for a program; else the default, with the program in its name where that is taken.
QString ExportDialog::folderFor(const ExportTarget* target) const {
    for (std::size_t k = m_targets.size(); k-- > 0;) {
        if (m_targets[k].target == target) return m_targets[k].folder;
    }
    const QString folder = defaultExportFolder(m_workspace);
    if (!isOfOtherProgram(folder, target)) return folder;
    return folder + '-' + QString::fromStdString(std::string(target->word));
}

/// Selects the formats that the program reads, and their kind, and a folder that holds no export for another program;
/// how the meshes are written otherwise stays.
void ExportDialog::applyTarget() {
    if (const ExportOptions now = options(); isOfOtherProgram(now.folder, now.target))
        m_folder->setText(QDir::toNativeSeparators(folderFor(now.target)));
    PackOptions pack = options().pack;
    const PackOptions needed = options().target->options();
    pack.meshes.formats = needed.meshes.formats;
    pack.meshes.glbKind = needed.meshes.glbKind;
    showFiles(pack);
    refresh();
}

/// Shows what will be written, and enables what is relevant.
void ExportDialog::refresh() {
    const ExportOptions options = this->options();
    m_description->setText(exportText(options.target->description));
    m_contents->setEnabled(!options.assets && hasScene(m_workspace.project()));
    const std::vector<const ExportFormat*> formats = formatsOf(options.pack.meshes.formats);
    for (const auto& [option, box] : m_options) {
        const auto hasOption = [&](const ExportFormat* format) {
            return std::ranges::find(format->options, option) != format->options.end();
        };
        box->setEnabled(option->isUsed(options.pack) && std::ranges::any_of(formats, hasOption));
    }
    const QString problem = selectedAssets().empty()   ? tr("No asset is selected.")
                            : options.folder.isEmpty() ? tr("No folder is set.")
                                                       : QString();
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_export->setEnabled(problem.isEmpty());
    if (problem.isEmpty()) return m_tree->setListing(exportListing(m_workspace, options));
    m_tree->clear();
}

}  // namespace rubble

#include "moc_ExportDialog.cpp"
