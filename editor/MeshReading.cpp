#include "editor/MeshReading.h"

#include "core/io/MeshImport.h"
#include "editor/ChoiceBox.h"
#include "editor/TaskDialog.h"

#include <QApplication>
#include <QFileInfo>
#include <QMessageBox>

#include <array>

namespace rubble {

std::optional<SourceScene> readMesh(const QString& path, const std::filesystem::path& importer, QWidget* parent) {
    TaskDialog dialog(QApplication::translate("MeshReading", "Reading %1…").arg(QFileInfo(path).fileName()), parent);
    Result<SourceScene> scene = dialog.run<Result<SourceScene>>(
        [&](const TaskContext& task) { return importMesh(path.toStdString(), importer, task); });
    if (scene) return std::move(*scene);
    if (scene.error().code != ErrorCode::Cancelled) {
        QMessageBox::warning(parent, QApplication::applicationDisplayName(),
                             QString::fromStdString(scene.error().message));
    }
    return std::nullopt;
}

QComboBox* unitBox() {
    const auto tr = [](const char* text) { return QApplication::translate("MeshReading", text); };
    return choiceBox(
        {tr("As the file says"), tr("Metres"), tr("Centimetres"), tr("Millimetres"), tr("Inches"), tr("Feet")},
        tr("What one unit of the file is"));
}

std::optional<double> metresOf(const QComboBox& unitBox) {
    constexpr std::array kMetres = {0.0, 1.0, 0.01, 0.001, 0.0254, 0.3048};
    if (unitBox.currentIndex() <= 0) return std::nullopt;
    return kMetres[static_cast<std::size_t>(unitBox.currentIndex())];
}

}  // namespace rubble
