#include "editor/dialogs/import/MeshReading.h"

#include "core/io/mesh/MeshImport.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/TaskDialog.h"

#include <QCoreApplication>

#include <array>

namespace rubble {

namespace {

struct MeshReadingTexts {
    Q_DECLARE_TR_FUNCTIONS(MeshReading)
};

}  // namespace

std::optional<SourceScene> readMesh(const QString& path, const std::filesystem::path& importer, QWidget* parent) {
    TaskDialog dialog(MeshReadingTexts::tr("Reading %1…").arg(fileNameText(path)), parent);
    Result<SourceScene> scene = dialog.run<Result<SourceScene>>(
        [&](const TaskContext& task) { return importMesh(toPath(path), importer, task); });
    if (scene) return std::move(*scene);
    if (scene.error().code != ErrorCode::Cancelled) showError(parent, scene.error());
    return std::nullopt;
}

QComboBox* createUnitBox() {
    return comboBox(
        {MeshReadingTexts::tr("As in the file"), MeshReadingTexts::tr("Metres"), MeshReadingTexts::tr("Centimetres"),
         MeshReadingTexts::tr("Millimetres"), MeshReadingTexts::tr("Inches"), MeshReadingTexts::tr("Feet")},
        MeshReadingTexts::tr("Set the unit of the file"));
}

std::optional<double> metresPerUnit(const QComboBox& unitBox) {
    constexpr std::array kMetres = {0.0, 1.0, 0.01, 0.001, 0.0254, 0.3048};
    if (unitBox.currentIndex() <= 0) return std::nullopt;
    return kMetres[static_cast<std::size_t>(unitBox.currentIndex())];
}

}  // namespace rubble
