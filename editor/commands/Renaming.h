#pragma once

#include "editor/document/Edit.h"

namespace rubble {

/// Why a material, an asset or an instance cannot have a name, as a sentence: it is empty or taken. Empty if it can.
QString nameFault(const Project& project, Part part, Id id, const QString& name);

/// Renames a material, an asset or an instance, and nothing else; nameFault() must be empty.
Edit renameElement(const Project& project, Part part, Id id, const QString& name);

/// The name of a material, an asset or an instance; empty if it does not exist.
QString nameOf(const Project& project, Part part, Id id);

}  // namespace rubble
