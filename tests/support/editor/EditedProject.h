#pragma once

#include "core/asset/checks/VerifyProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Document.h"

#include <QtGlobal>

#include <utility>

namespace rubble::test {

/// The project after an edit, which must be valid; undoing the edit must restore the bytes.
inline Project editedProject(const Project& project, Edit edit) {
    Document document(project);
    document.push(std::move(edit));
    const Project edited = document.project();
    if (const auto fault = verifyProject(edited)) qFatal("%s", fault->c_str());
    document.undoStack().undo();
    if (projectText(document.project()) != projectText(project)) qFatal("Undoing gives another project.");
    return edited;
}

}  // namespace rubble::test
