#include "editor/actions/MaterialActions.h"

#include "editor/dialogs/MaterialDialog.h"
#include "editor/dialogs/MaterialPictures.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"

#include <QDir>
#include <QMainWindow>

namespace rubble {

MaterialActions::MaterialActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_pictures(new MaterialPictures(this)),
      m_library(makeAction(this, {"material-library", tr("&Material Library…"),
                                  tr("Select a material from the library for the active asset")})),
      m_save(makeAction(this, {"material-save", tr("Sa&ve Material as Preset…"),
                               tr("Save this material as a preset for other projects")})) {
    connect(m_library, &QAction::triggered, this, &MaterialActions::openLibrary);
    connect(m_save, &QAction::triggered, this, &MaterialActions::saveAsPreset);
}

void MaterialActions::openLibrary() {
    m_views.showProject();
    Workspace& workspace = m_views.workspace();
    MaterialDialog(workspace.document(), workspace.selection(), *m_pictures, materialFolder(), m_views.units(),
                   &m_views.window())
        .exec();
}

/// Saves the selected material, or that of the active asset.
void MaterialActions::saveAsPreset() {
    Workspace& workspace = m_views.workspace();
    const Selection& selection = workspace.selection();
    const Asset* asset = workspace.asset();
    const bool isMaterialSelected = selection.subject() == Part::Material || asset == nullptr;
    const Id material = isMaterialSelected ? selection.material() : asset->material;
    if (findMaterial(workspace.project(), material) == nullptr) {
        return m_views.showStatus(tr("No material is selected. Select a material or an asset in the project tree."));
    }
    const MaterialPreset preset = presetFrom(workspace.project(), material, selection.asset());
    QDir().mkpath(materialFolder());
    const std::filesystem::path path = materialPresetPath(toPath(materialFolder()), preset.name);
    const QString file = fromPath(path);
    const QString question = tr("A preset named \"%1\" exists already. Replace it?");
    if (exists(statusOf(file)) &&
        !confirmLoss(&m_views.window(), question.arg(nameText(preset.name)), tr("Replace"), tr("Cancel"))) {
        return;
    }
    const Status saved = saveMaterialPreset(path, preset);
    showIfError(&m_views.window(), saved);
    if (saved) m_views.showStatus(tr("Saved %1.").arg(pathText(file)));
}

}  // namespace rubble

#include "moc_MaterialActions.cpp"
