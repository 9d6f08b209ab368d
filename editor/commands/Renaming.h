#pragma once

#include "editor/document/Edit.h"

namespace rubble {

/// Why a material, an asset or an instance cannot have a name, as a sentence: it is empty or taken. Empty if it can.
QString nameFault(const Project& project, Part part, Id id, const QString& name);

/// Renames a material, an asset or an instance; nameFault() must be empty. An asset and its instance of the same name
/// are renamed together, unless the new name is taken.
Edit renameElement(const Project& project, Part part, Id id, const QString& name);

/// Renames with the assets and instances that an edit renames those that have the same name now: the instances of the
/// asset, the asset of the instance, where the new name is free.
void renameNamesakes(const Project& project, Edit& edit);

/// The name of a material, an asset or an instance; empty if it does not exist.
QString nameOf(const Project& project, Part part, Id id);

}  // namespace rubble
