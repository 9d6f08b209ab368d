#include "editor/ExportDialog.h"

#include "core/io/PackExport.h"
#include "editor/TaskDialog.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QMessageBox>
#include <QSettings>

namespace rubble {

namespace {

/// Where the settings keep a project's last export; empty for one that lies nowhere.
QString keyOf(const QString& projectPath) {
    if (projectPath.isEmpty()) return {};
    const QByteArray hash = QCryptographicHash::hash(projectPath.toUtf8(), QCryptographicHash::Sha1).toHex();
    return "exports/" + QString::fromLatin1(hash);
}

void keep(const QString& key, const ExportChoice& choice) {
    if (key.isEmpty()) return;
    QSettings settings;
    settings.beginGroup(key);
    settings.setValue("folder", choice.folder);
    settings.setValue("obj", choice.meshes.obj);
    settings.setValue("glb", choice.meshes.glb);
    settings.setValue("filePerFragment", choice.meshes.split == FileSplit::PerFragment);
    settings.setValue("centred", choice.meshes.place == PartPlace::Centred);
    settings.setValue("triangles", choice.meshes.faces == FaceShape::Triangles);
    if (!choice.assets) return settings.remove("assets");
    QStringList assets;
    for (const Id asset : *choice.assets) assets.append(QString::number(asset));
    settings.setValue("assets", assets);
}

std::vector<Id> assetsOf(const ExportChoice& choice, const Project& project) {
    if (choice.assets) return *choice.assets;
    std::vector<Id> assets;
    for (const Asset& asset : project.assets) assets.push_back(asset.id);
    return assets;
}

void tell(const QString& text, const QStringList& details, QWidget* parent) {
    QMessageBox box(QMessageBox::Warning, QApplication::applicationDisplayName(), text, QMessageBox::Ok, parent);
    box.setDetailedText(details.join('\n'));
    box.exec();
}

QString summary(const std::vector<AssetExport>& exports, const QString& folder, Messages& messages, QWidget* parent) {
    QStringList faults;
    int written = 0, unchanged = 0;
    for (const AssetExport& asset : exports) {
        if (asset.status) {
            ++(asset.isUnchanged ? unchanged : written);
            continue;
        }
        faults.append(QString::fromStdString(asset.status.error().message));
        messages.add({.severity = Severity::Fault, .text = faults.last(), .asset = asset.asset});
    }
    if (!faults.isEmpty()) {
        tell(QCoreApplication::translate("Export", "Assets that could not be exported: %1.").arg(faults.size()), faults,
             parent);
    }
    const QString place = QDir::toNativeSeparators(folder);
    if (unchanged == 0)
        return QCoreApplication::translate("Export", "Assets exported to %2: %1.").arg(written).arg(place);
    return QCoreApplication::translate("Export", "Assets exported to %2: %1; there already, unchanged: %3.")
        .arg(written)
        .arg(place)
        .arg(unchanged);
}

}  // namespace

std::optional<ExportChoice> lastExport(Workspace& workspace) {
    const QString key = keyOf(workspace.file().path());
    QSettings settings;
    if (key.isEmpty() || !settings.contains(key + "/folder")) return std::nullopt;
    settings.beginGroup(key);
    ExportChoice choice{.folder = settings.value("folder").toString()};
    choice.meshes.obj = settings.value("obj").toBool();
    choice.meshes.glb = settings.value("glb").toBool();
    if (settings.value("filePerFragment").toBool()) choice.meshes.split = FileSplit::PerFragment;
    if (settings.value("centred").toBool()) choice.meshes.place = PartPlace::Centred;
    if (settings.value("triangles").toBool()) choice.meshes.faces = FaceShape::Triangles;
    if (!settings.contains("assets")) return choice;
    choice.assets.emplace();
    for (const QString& asset : settings.value("assets").toStringList()) {
        if (findAsset(workspace.project(), asset.toUInt())) choice.assets->push_back(asset.toUInt());
    }
    return choice;
}

QString exported(Workspace& workspace, const ExportChoice& choice, Messages& messages, QWidget* parent) {
    keep(keyOf(workspace.file().path()), choice);
    const Project project = workspace.project();
    const std::vector<Id> assets = assetsOf(choice, project);
    using Outcome = Result<std::vector<AssetExport>>;
    TaskDialog dialog(QCoreApplication::translate("Export", "Exporting…"), parent);
    const Outcome outcome = dialog.run<Outcome>([&](const TaskContext& task) {
        return exportPacks(project, assets, choice.folder.toStdString(), choice.meshes, task);
    });
    if (outcome) {
        const QString sentence = summary(*outcome, choice.folder, messages, parent);
        messages.add({.text = sentence});
        return sentence;
    }
    if (outcome.error().code == ErrorCode::Cancelled) {
        return QCoreApplication::translate("Export", "Export cancelled; nothing was left half-written.");
    }
    const QString sentence = QString::fromStdString(outcome.error().message);
    messages.add({.severity = Severity::Fault, .text = sentence});
    tell(sentence, {}, parent);
    return sentence;
}

}  // namespace rubble
