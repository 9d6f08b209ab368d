#include "editor/MaterialActions.h"

#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/MaterialDialog.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>

namespace rubble {

MaterialActions::MaterialActions(MainWindow& window)
    : QObject(&window),
      m_window(window),
      m_library(
          makeAction(this, {"material-library", tr("&Material Library…"),
                            tr("Choose a material with figures from books and standards, and its usual pattern")})),
      m_save(makeAction(this, {"material-save", tr("Save Material as &Preset…"),
                               tr("Keep the chosen material, or that of the asset at hand, for other projects")})) {
    connect(m_library, &QAction::triggered, this, &MaterialActions::openLibrary);
    connect(m_save, &QAction::triggered, this, &MaterialActions::saveAsPreset);
}

void MaterialActions::openLibrary() {
    m_window.showWork();
    MaterialDialog(m_window.workspace().document(), m_window.workspace().selection(), materialFolder(), &m_window)
        .exec();
}

void MaterialActions::saveAsPreset() {
    const Workspace& workspace = m_window.workspace();
    const Selection& selection = m_window.workspace().selection();
    const Asset* asset = m_window.workspace().asset();
    const bool isMaterialChosen = selection.subject() == Part::Material || asset == nullptr;
    const Id material = isMaterialChosen ? selection.material() : asset->material;
    if (findMaterial(workspace.project(), material) == nullptr)
        return m_window.say(tr("There is no material to save."));
    const MaterialPreset preset = presetFrom(workspace.project(), material, selection.asset());
    QDir().mkpath(materialFolder());
    const std::filesystem::path path = materialPresetPath(materialFolder().toStdString(), preset.name);
    const QString file = QDir::toNativeSeparators(QString::fromStdString(path.string()));
    const QString question = tr("\"%1\" is a preset already. Replace it?").arg(QString::fromStdString(preset.name));
    if (QFileInfo::exists(file) &&
        QMessageBox::question(&m_window, tr("Save Material as Preset"), question) != QMessageBox::Yes) {
        return;
    }
    const Status saved = saveMaterialPreset(path, preset);
    if (saved) return m_window.say(tr("Saved %1.").arg(file));
    QMessageBox::warning(&m_window, tr("Save Material as Preset"), QString::fromStdString(saved.error().message));
}

}  // namespace rubble
