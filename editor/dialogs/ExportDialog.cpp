#include "editor/dialogs/ExportDialog.h"

#include "core/io/pack/SceneFile.h"
#include "editor/dialogs/ExportTree.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/ScreenFit.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kDescriptionLines = 2;          // of the longest one
constexpr QSize kExportDialogSize{800, 540};  // pixels, so that a path and file names fit

/// What is written for a program unless the user changes it: see optionsFor().
QString descriptionOf(ExportTarget target) {
    switch (target) {
        case ExportTarget::Neutral:
            return ExportDialog::tr("OBJ and GLB meshes, and the bodies in pack.json and pack.bin.");
        case ExportTarget::Unity:
            return ExportDialog::tr("GLB meshes for glTFast or UnityGLTF; a script reads pack.json or pack.bin.");
        case ExportTarget::Unreal:
            return ExportDialog::tr(
                "GLB with collision hulls, a script that imports them, and pack.json and pack.bin.");
        case ExportTarget::Godot:
            return ExportDialog::tr("GLB with rigid bodies, which Godot 4.3 and later read on import; and pack.json.");
        case ExportTarget::Blender:
            return ExportDialog::tr("GLB meshes, which Blender imports; and masses in pack.json.");
        case ExportTarget::Web:
            return ExportDialog::tr("GLB with rigid bodies for three.js and Babylon.js; and pack.json.");
        case ExportTarget::Usd:
            return ExportDialog::tr("USD with rigid bodies, colliders and breakable joints; and pack.json.");
    }
    return {};
}

QCheckBox* checkBox(const QString& text, const QString& toolTip) {
    auto* box = new QCheckBox(text);
    box->setToolTip(toolTip);
    return box;
}

ExportOptions defaultOptions(Workspace& workspace) {
    const QString path = workspace.file().path();
    const QString base = path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                        : QFileInfo(path).absolutePath();
    return {.folder = base + "/packs"};
}

}  // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), m_workspace(workspace) {
    setWindowTitle(tr("Export"));
    addFields();
    addForm();
    showOptions(lastExportOptions(workspace).value_or(defaultOptions(workspace)));
    connect(m_target, &QComboBox::currentIndexChanged, this, &ExportDialog::applyTarget);
    for (QCheckBox* box : {m_obj, m_glb, m_usd, m_mjcf})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    for (QComboBox* box : {m_contents, m_glbKind, m_split, m_place, m_faces}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
    }
    connect(m_assets, &QListWidget::itemChanged, this, &ExportDialog::refresh);
    connect(m_folder, &QLineEdit::textChanged, this, &ExportDialog::refresh);
    refresh();
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
    m_target = comboBox({tr("Any engine"), "Unity", "Unreal Engine", "Godot", "Blender", tr("Web"), "USD"},
                        tr("Select the program that the export is for; a README.md says how to use it there"));
    m_description = new QLabel;
    m_description->setObjectName("program-description");
    m_description->setWordWrap(true);
    m_description->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_description->setMinimumHeight(kDescriptionLines * m_description->fontMetrics().lineSpacing());
    m_obj = checkBox(tr("&OBJ with materials"), tr("Write Wavefront OBJ files, which all 3D programs read"));
    m_glb = checkBox(tr("&GLB"), tr("Write binary glTF files"));
    m_usd = checkBox(tr("U&SD"), tr("Write USD files with rigid bodies and colliders of UsdPhysics"));
    m_mjcf = checkBox(tr("MuJo&Co"), tr("Write the fragments as a model of MuJoCo (MJCF)"));
    m_glbKind = comboBox({tr("Plain"), tr("With rigid bodies"), tr("Compact"), tr("With hulls for Unreal Engine")},
                         tr("Select the content of GLB files: a node per fragment; the same with rigid bodies and "
                            "colliders; one skinned mesh, small and drawn at once; or with hulls called UCX_"));
    m_split = comboBox({tr("One file for all"), tr("One file each")},
                       tr("Select one file for all fragments or one file per fragment"));
    m_place = comboBox({tr("Assembled"), tr("Centred on the centre of mass")},
                       tr("Select the position of the fragments in the mesh files"));
    m_faces = comboBox({tr("Polygons"), tr("Triangles")}, tr("Select the faces of OBJ files"));
    m_up = comboBox({tr("Y up"), tr("Z up")}, tr("Select the up axis of OBJ files; GLB files always have y up"));
    m_unit = comboBox({tr("Metres"), tr("Centimetres"), tr("Millimetres")},
                      tr("Select the unit of OBJ files; GLB files are always in metres"));
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
    form.addRow(tr("GLB &kind:"), m_glbKind);
    form.addRow(tr("Frag&ments:"), m_split);
    form.addRow(tr("Posi&tion:"), m_place);
    form.addRow(tr("OBJ fac&es:"), m_faces);
    form.addRow(tr("OBJ a&xes:"), m_up);
    form.addRow(tr("OBJ &unit:"), m_unit);
    form.addRow(m_onSave);
}

QGridLayout* ExportDialog::createFormats() const {
    auto* formats = new QGridLayout;
    formats->addWidget(m_obj, 0, 0);
    formats->addWidget(m_glb, 1, 0);
    formats->addWidget(m_usd, 0, 1);
    formats->addWidget(m_mjcf, 1, 1);
    return formats;
}

/// The list of earlier exports; null where there is at most the one that is shown anyway.
QWidget* ExportDialog::createTargets() {
    m_targets = exportTargets(m_workspace);
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
        m_targetList->addItem(m_target->itemText(static_cast<int>(target.target)) + " · " + pathText(target.folder));
    m_targetList->setCurrentIndex(m_targetList->count() - 1);
}

void ExportDialog::forgetTarget() {
    const int index = m_targetList->currentIndex();
    if (index < 0) return;
    forgetExportTarget(m_workspace, m_targets[static_cast<std::size_t>(index)].folder);
    m_targets = exportTargets(m_workspace);
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
    m_target->setCurrentIndex(static_cast<int>(options.target));
    showFormats(options.meshes);
    m_split->setCurrentIndex(options.meshes.split == FileSplit::PerFragment);
    m_place->setCurrentIndex(options.meshes.place == PartPlacement::Centred);
    m_faces->setCurrentIndex(options.meshes.faces == FaceShape::Triangles);
    m_up->setCurrentIndex(options.meshes.objFrame.up == UpAxis::Z);
    m_unit->setCurrentIndex(static_cast<int>(options.meshes.objFrame.unit));
}

void ExportDialog::showFormats(const MeshOptions& meshes) {
    m_obj->setChecked(meshes.obj);
    m_glb->setChecked(meshes.glb);
    m_usd->setChecked(meshes.usd);
    m_mjcf->setChecked(meshes.mjcf);
    m_glbKind->setCurrentIndex(static_cast<int>(meshes.glbKind));
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
    options.target = static_cast<ExportTarget>(m_target->currentIndex());
    options.meshes.obj = m_obj->isChecked();
    options.meshes.glb = m_glb->isChecked();
    options.meshes.usd = m_usd->isChecked();
    options.meshes.mjcf = m_mjcf->isChecked();
    options.meshes.glbKind = static_cast<GlbKind>(m_glbKind->currentIndex());
    options.meshes.split = m_split->currentIndex() == 1 ? FileSplit::PerFragment : FileSplit::Single;
    options.meshes.place = m_place->currentIndex() == 1 ? PartPlacement::Centred : PartPlacement::Assembled;
    options.meshes.faces = m_faces->currentIndex() == 1 ? FaceShape::Triangles : FaceShape::Polygons;
    options.meshes.objFrame.up = m_up->currentIndex() == 1 ? UpAxis::Z : UpAxis::Y;
    options.meshes.objFrame.unit = static_cast<ObjUnit>(m_unit->currentIndex());
    return options;
}

void ExportDialog::browse() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Export Folder"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(QDir::toNativeSeparators(folder));
}

/// Selects the meshes that the program reads.
void ExportDialog::applyTarget() {
    showFormats(optionsFor(options().target).meshes);
    refresh();
}

/// Shows what will be written, and enables what is relevant.
void ExportDialog::refresh() {
    const ExportOptions options = this->options();
    const MeshOptions& meshes = options.meshes;
    m_description->setText(descriptionOf(options.target));
    m_contents->setEnabled(!options.assets && hasScene(m_workspace.project()));
    m_split->setEnabled(meshes.obj || meshes.glb);
    m_place->setEnabled(meshes.obj || meshes.glb);
    m_glbKind->setEnabled(meshes.glb);
    for (QComboBox* box : {m_faces, m_up, m_unit}) box->setEnabled(meshes.obj);
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
