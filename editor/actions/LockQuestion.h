#pragma once

#include "editor/document/ProjectAccess.h"

#include <optional>

class QWidget;

namespace rubble {

/// Locks a project for writing. If another process holds the lock, says which, and asks whether to open the project
/// read-only or, unless the process is known to be running, to take the lock over. Returns nothing if the user cancels.
std::optional<ProjectAccess> askForAccess(const QString& path, QWidget* parent);

/// Locks a path that a project is to be saved to. If another process holds the lock that is not known to be running,
/// says which, and asks whether to take the lock over. Returns nothing if the user cancels.
std::optional<ProjectAccess> askToSave(const QString& path, QWidget* parent);

}  // namespace rubble
