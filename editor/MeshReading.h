#pragma once

#include "core/geometry/SourceScene.h"

#include <QString>

#include <filesystem>
#include <optional>

class QComboBox;
class QWidget;

namespace rubble {

/// Reads a mesh file by the importer's program, with progress. Nothing where it could not be read, which the user has been
/// told, or was cancelled.
std::optional<SourceScene> readMesh(const QString& path, const std::filesystem::path& importer, QWidget* parent);

/// Asks what one unit of a mesh file is; and what was chosen, m, nothing for what the file says.
QComboBox* unitBox();
std::optional<double> metresOf(const QComboBox& unitBox);

}  // namespace rubble
