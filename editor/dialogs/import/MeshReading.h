#pragma once

#include "core/geometry/mesh/SourceScene.h"

#include <QString>

#include <filesystem>
#include <optional>

class QComboBox;
class QWidget;

namespace rubble {

/// Reads a mesh file with the importer program and shows progress. Returns none if the file cannot be read, after
/// showing the error, or if the user cancels.
std::optional<SourceScene> readMesh(const QString& path, const std::filesystem::path& importer, QWidget* parent);

/// Creates a combo box for the unit of a mesh file.
QComboBox* createUnitBox();
/// Returns the length of the selected unit, m; none for the unit that the file states.
std::optional<double> metresPerUnit(const QComboBox& unitBox);

}  // namespace rubble
