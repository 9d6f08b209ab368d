#include "editor/ExportDialog.h"

#include "core/io/ExportFolder.h"
#include "editor/ChoiceBox.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMostNames = 4;  // of folders that the summary lists

ExportChoice usualChoice(Workspace& workspace) {
    const QString path = workspace.file().path();
    const QString base = path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                        : QFileInfo(path).absolutePath();
    return {.folder = base + "/packs"};
}

}  // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), m_workspace(workspace) {
    setWindowTitle(tr("Export"));
    makeFields();
    fill(lastExport(workspace).value_or(usualChoice(workspace)));
    for (QCheckBox* box : {m_obj, m_glb}) connect(box, &QCheckBox::toggled, this, &ExportDialog::update);
    for (QComboBox* box : {m_split, m_place, m_faces}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::update);
    }
    connect(m_assets, &QListWidget::itemChanged, this, &ExportDialog::update);
    connect(m_folder, &QLineEdit::textChanged, this, &ExportDialog::update);
    update();
}

void ExportDialog::makeFields() {
    m_assets = new QListWidget;
    m_assets->setAccessibleName(tr("Assets to export"));
    m_assets->setToolTip(tr("Each chosen asset gets a folder of its name"));
    m_folder = new QLineEdit;
    m_folder->setToolTip(tr("The folder that the assets' folders go into"));
    auto* browse = new QPushButton(tr("Browse…"));
    connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
    auto* folderRow = new QHBoxLayout;
    folderRow->addWidget(m_folder, 1);
    folderRow->addWidget(browse);
    m_obj = new QCheckBox(tr("&OBJ, with materials"));
    m_obj->setToolTip(tr("Wavefront OBJ: read by every 3D program"));
    m_glb = new QCheckBox(tr("&GLB"));
    m_glb->setToolTip(tr("Binary glTF: a node for each fragment, at its place"));
    m_split = choiceBox({tr("All in one file"), tr("A file each")}, tr("Which fragments share a mesh file"));
    m_place = choiceBox({tr("At their places"), tr("Each about its centre of mass")},
                        tr("Where fragments stand in the files"));
    m_faces = choiceBox({tr("Polygons"), tr("Triangles")}, tr("What the faces of OBJ files are"));
    m_summary = new QLabel;
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout(this);
    form->addRow(tr("&Assets:"), m_assets);
    auto* folderLabel = new QLabel(tr("&Folder:"));
    folderLabel->setBuddy(m_folder);
    form->addRow(folderLabel, folderRow);
    form->addRow(tr("Meshes:"), m_obj);
    form->addRow(QString(), m_glb);
    form->addRow(tr("Frag&ments:"), m_split);
    form->addRow(tr("&Placed:"), m_place);
    form->addRow(tr("OBJ fa&ces:"), m_faces);
    form->addRow(m_summary);
    form->addRow(buttons);
    m_export->setDefault(true);  // a button knows its dialog only now
    resize(sizeHint().expandedTo({520, 0}));
}

void ExportDialog::fill(const ExportChoice& choice) {
    for (const Asset& asset : m_workspace.project().assets) {
        auto* item = new QListWidgetItem(QString::fromStdString(asset.name), m_assets);
        item->setData(Qt::UserRole, asset.id);
        const bool isChosen = !choice.assets || std::ranges::find(*choice.assets, asset.id) != choice.assets->end();
        item->setCheckState(isChosen ? Qt::Checked : Qt::Unchecked);
    }
    m_folder->setText(QDir::toNativeSeparators(choice.folder));
    m_obj->setChecked(choice.meshes.obj);
    m_glb->setChecked(choice.meshes.glb);
    m_split->setCurrentIndex(choice.meshes.split == FileSplit::PerFragment);
    m_place->setCurrentIndex(choice.meshes.place == PartPlace::Centred);
    m_faces->setCurrentIndex(choice.meshes.faces == FaceShape::Triangles);
}

std::vector<Id> ExportDialog::chosenAssets() const {
    std::vector<Id> chosen;
    for (int row = 0; row < m_assets->count(); ++row) {
        const QListWidgetItem* item = m_assets->item(row);
        if (item->checkState() == Qt::Checked) chosen.push_back(item->data(Qt::UserRole).toUInt());
    }
    return chosen;
}

ExportChoice ExportDialog::choice() const {
    ExportChoice choice{.folder = QDir::fromNativeSeparators(m_folder->text())};
    std::vector<Id> chosen = chosenAssets();
    const bool areAll = static_cast<int>(chosen.size()) == m_assets->count();
    if (!areAll) choice.assets = std::move(chosen);  // all: those that are added later, too
    choice.meshes.obj = m_obj->isChecked();
    choice.meshes.glb = m_glb->isChecked();
    choice.meshes.split = m_split->currentIndex() == 1 ? FileSplit::PerFragment : FileSplit::Single;
    choice.meshes.place = m_place->currentIndex() == 1 ? PartPlace::Centred : PartPlace::Assembled;
    choice.meshes.faces = m_faces->currentIndex() == 1 ? FaceShape::Triangles : FaceShape::Polygons;
    return choice;
}

void ExportDialog::browse() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Export Folder"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(QDir::toNativeSeparators(folder));
}

/// Says what will be written.
void ExportDialog::update() {
    const ExportChoice chosen = choice();
    const std::vector<Id> assets = chosenAssets();
    m_split->setEnabled(chosen.meshes.obj || chosen.meshes.glb);
    m_place->setEnabled(chosen.meshes.obj || chosen.meshes.glb);
    m_faces->setEnabled(chosen.meshes.obj);
    m_export->setEnabled(!assets.empty() && !chosen.folder.isEmpty());
    QStringList folders;
    for (const Id id : assets) {
        if (folders.size() == kMostNames) {
            folders.append("…");
            break;
        }
        folders.append(QString::fromStdString(safeFileName(findAsset(m_workspace.project(), id)->name)));
    }
    const QString meshes = chosen.meshes.obj && chosen.meshes.glb ? tr("OBJ and GLB meshes")
                           : chosen.meshes.obj                    ? tr("OBJ meshes")
                           : chosen.meshes.glb                    ? tr("a GLB mesh")
                                                                  : tr("no meshes");
    m_summary->setText(
        assets.empty()
            ? tr("No asset is chosen.")
            : tr("Folders that will be written, each with pack.json and %1: %2.").arg(meshes, folders.join(", ")));
}

}  // namespace rubble
