#pragma once

#include "editor/play/PlayToolSettings.h"

#include <QSettings>

namespace rubble {

class Workspace;

/// Returns the stored settings of the play tools for a project, by its path; a missing or invalid value gets its
/// default. A projectile that is an asset of a project is not kept, nor whether a click throws.
PlayToolSettings readPlayTools(const QSettings& settings, const QString& project);
/// Stores nothing for a project without a file.
void writePlayTools(const PlayToolSettings& tools, const QString& project, QSettings& settings);

/// Keeps the settings of a workspace's play tools with its project: what suits a pane does not suit a house. A project
/// that has none keeps those that are set; defaults are not stored, so that they follow the size of the scene.
void keepPlayTools(Workspace& workspace);

}  // namespace rubble
