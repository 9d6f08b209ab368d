#pragma once

#include "editor/document/Edit.h"

namespace rubble {

/// What is wrong with a name for a material, an asset or an instance, as a sentence: it is empty or another one's. Empty
/// where it may be taken.
QString nameFault(const Project& project, Part part, Id id, const QString& name);

/// Gives a material, an asset or an instance another name, which has no fault.
Edit renamed(const Project& project, Part part, Id id, const QString& name);

/// The name of a material, an asset or an instance; empty where it is not there.
QString nameOf(const Project& project, Part part, Id id);

}  // namespace rubble
